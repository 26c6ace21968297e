open Candor_scene

let name = "textures"
let meaning = "colours vary over surfaces"

let varies : Texture.t -> bool = function
  | Constant _ -> false
  | Checker _ | Noise _ | Image _ -> true

let is_textured (m : Material.t) =
  match m.kind with
  | Matte { color }
  | Phong { color; _ }
  | Mirror { color }
  | Glazed { color; _ }
  | Glass { color; _ }
  | Plastic { color; _ } ->
      varies color
  | Metal { reflectance; _ } -> varies reflectance
  | Translucent _ | Emitter -> false

let calls = Reason.materials is_textured
