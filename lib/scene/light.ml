open Candor_space
open Candor_colour

type falloff = Square | Constant [@@deriving show, eq, ord]

type kind =
  | Point of { at : Point.t; intensity : Rgb.t; falloff : falloff }
  | Directional of { direction : Vec.t; irradiance : Rgb.t }
  | Spot of {
      at : Point.t;
      toward : Point.t;
      intensity : Rgb.t;
      inner : float;
      outer : float;
      falloff : falloff;
    }
[@@deriving show, eq, ord]

type t = { kind : kind; shadows : bool; place : Place.t }
[@@deriving show, eq, ord]
