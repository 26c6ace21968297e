open Candor_colour

type t = Constant of Rgb.t | Checker of { even : t; odd : t; scale : float }
[@@deriving show, eq, ord]
