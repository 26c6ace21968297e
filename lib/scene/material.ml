open Candor_colour

type t =
  | Matte of { color : Texture.t }
  | Phong of { color : Texture.t; specular : Rgb.t; shininess : float }
  | Mirror of { color : Texture.t }
  | Glazed of { color : Texture.t; mirror : Rgb.t }
[@@deriving show, eq, ord]

let default = Matte { color = Constant (Rgb.grey 0.5) }
