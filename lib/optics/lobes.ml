open Candor_colour
open Candor_scene

type highlight = { specular : Rgb.t; shininess : float }
type t = { diffuse : Rgb.t; highlight : highlight option; mirror : Rgb.t }

let of_material (m : Material.t) local =
  match m with
  | Matte { color } ->
      {
        diffuse = Colour_at.v color local;
        highlight = None;
        mirror = Rgb.black;
      }
  | Phong { color; specular; shininess } ->
      {
        diffuse = Colour_at.v color local;
        highlight = Some { specular; shininess };
        mirror = Rgb.black;
      }
  | Mirror { color } ->
      {
        diffuse = Rgb.black;
        highlight = None;
        mirror = Colour_at.v color local;
      }
  | Glazed { color; mirror } ->
      { diffuse = Colour_at.v color local; highlight = None; mirror }

let rec all_black : Texture.t -> bool = function
  | Constant c -> Rgb.is_black c
  | Checker { even; odd; _ } -> all_black even && all_black odd

let mirrors : Material.t -> bool = function
  | Matte _ | Phong _ -> false
  | Mirror { color } -> not (all_black color)
  | Glazed { mirror; _ } -> not (Rgb.is_black mirror)

let diffuses : Material.t -> bool = function
  | Matte { color } | Glazed { color; _ } -> not (all_black color)
  | Phong { color; specular; _ } ->
      not (all_black color && Rgb.is_black specular)
  | Mirror _ -> false
