open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene

type highlight = { specular : Rgb.t; shininess : float }

type t = {
  diffuse : Rgb.t;
  highlight : highlight option;
  mirror : Rgb.t;
  gloss : Gloss.t option;
}

let none =
  { diffuse = Rgb.black; highlight = None; mirror = Rgb.black; gloss = None }

type at = Local.t -> normal:Dir.t -> view:Vec.t -> t

(* [of_colour texture f] is [f] of the colour at a point, once where that is the
   same everywhere. *)
let of_colour (texture : Texture.t) f : at =
  match texture with
  | Constant c ->
      let lobes = f c in
      fun _ ~normal:_ ~view:_ -> lobes
  | Checker _ | Noise _ | Image _ ->
      fun local ~normal:_ ~view:_ -> f (Colour_at.v texture local)

(* A smooth coat is a mirror, the brighter the more it is seen at grazing
   angles. *)
let smooth texture ~gloss ~base : at =
 fun local ~normal ~view ->
  let gloss = gloss (Colour_at.v texture local) in
  let cos = Vec.dot (normal :> Vec.t) view /. Vec.norm view in
  { none with mirror = Gloss.specular gloss ~cos; gloss = base gloss }

let compile (m : Material.t) =
  match m.kind with
  | Matte { color } -> of_colour color (fun diffuse -> { none with diffuse })
  | Phong { color; specular; shininess } ->
      let highlight = Some { specular; shininess } in
      of_colour color (fun diffuse -> { none with diffuse; highlight })
  | Mirror { color } -> of_colour color (fun mirror -> { none with mirror })
  | Glazed { color; mirror } ->
      of_colour color (fun diffuse -> { none with diffuse; mirror })
  | Metal { reflectance; roughness } ->
      let gloss reflectance = Gloss.metal ~reflectance ~roughness in
      if roughness > 0. then
        of_colour reflectance (fun c -> { none with gloss = Some (gloss c) })
      else smooth reflectance ~gloss ~base:(fun _ -> None)
  | Plastic { color; index; roughness } ->
      let coat = Coat.make ~index ~roughness in
      let gloss color = Gloss.plastic coat ~color in
      if roughness > 0. then
        of_colour color (fun c -> { none with gloss = Some (gloss c) })
      else smooth color ~gloss ~base:Option.some
  | Glass _ | Translucent _ | Emitter -> fun _ ~normal:_ ~view:_ -> none

let lit texture = Texture.exists (fun c -> not (Rgb.is_black c)) texture

let mirrors (m : Material.t) =
  match m.kind with
  | Mirror { color } -> lit color
  | Glazed { mirror; _ } -> not (Rgb.is_black mirror)
  | Metal { roughness; _ } -> roughness = 0.
  | Plastic { roughness; index; _ } -> roughness = 0. && index <> 1.
  | Matte _ | Phong _ | Glass _ | Translucent _ | Emitter -> false

let diffuses (m : Material.t) =
  match m.kind with
  | Matte { color } | Glazed { color; _ } -> lit color
  | Phong { color; specular; _ } -> lit color || not (Rgb.is_black specular)
  | Mirror _ | Glass _ | Metal _ | Plastic _ | Translucent _ | Emitter -> false

let glosses (m : Material.t) =
  match m.kind with
  | Metal { roughness; _ } -> roughness > 0.
  | Plastic { color; roughness; index } ->
      lit color || (roughness > 0. && index <> 1.)
  | Matte _ | Phong _ | Mirror _ | Glazed _ | Glass _ | Translucent _ | Emitter
    ->
      false

let responds m = diffuses m || glosses m
