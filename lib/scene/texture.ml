open Candor_colour

type t =
  | Constant of Rgb.t
  | Checker of { even : t; odd : t; scale : float }
  | Noise of { first : t; second : t; scale : float; octaves : int }
  | Image of { file : string; texels : Texels.t }
[@@deriving show, eq, ord]

let rec exists p = function
  | Constant c -> p c
  | Checker { even; odd; _ } -> exists p even || exists p odd
  | Noise { first; second; _ } -> exists p first || exists p second
  | Image { texels; _ } -> Texels.exists p texels

let rec greatest = function
  | Constant c -> c
  | Checker { even; odd; _ } -> Rgb.greater (greatest even) (greatest odd)
  | Noise { first; second; _ } -> Rgb.greater (greatest first) (greatest second)
  | Image { texels; _ } -> Texels.greatest texels
