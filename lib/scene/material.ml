open Candor_colour

type kind =
  | Matte of { color : Texture.t }
  | Phong of { color : Texture.t; specular : Rgb.t; shininess : float }
  | Mirror of { color : Texture.t }
  | Glazed of { color : Texture.t; mirror : Rgb.t }
  | Glass of {
      index : float;
      color : Texture.t;
      absorption : Rgb.t;
      dispersion : float option;
    }
  | Metal of { reflectance : Texture.t; roughness : float }
  | Plastic of { color : Texture.t; index : float; roughness : float }
  | Translucent of {
      index : float;
      scattering : Rgb.t;
      absorption : Rgb.t;
      anisotropy : float;
    }
  | Emitter
[@@deriving show, eq, ord]

type t = { kind : kind; emission : Rgb.t } [@@deriving show, eq, ord]

let v kind = { kind; emission = Rgb.black }
let emits m = not (Rgb.is_black m.emission)
let default = v (Matte { color = Constant (Rgb.grey 0.5) })
