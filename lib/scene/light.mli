(** Lights without extent. *)

open Candor_space
open Candor_colour

type falloff =
  | Square  (** irradiance is intensity·cosθ/r² *)
  | Constant  (** irradiance is intensity·cosθ at any distance *)
[@@deriving show, eq, ord]

type kind =
  | Point of { at : Point.t; intensity : Rgb.t; falloff : falloff }
  | Directional of { direction : Vec.t; irradiance : Rgb.t }
      (** [direction] is the way that the light travels *)
  | Spot of {
      at : Point.t;
      toward : Point.t;
      intensity : Rgb.t;
      inner : float;
      outer : float;
      falloff : falloff;
    }
      (** half-angles in degrees, 0 ≤ inner ≤ outer ≤ 90: full within [inner],
          nothing beyond [outer], a smooth step of the cosine between *)
[@@deriving show, eq, ord]

type t = { kind : kind; shadows : bool; place : Place.t }
[@@deriving show, eq, ord]
(** [shadows] is [false] where the scene says [(shadows no)]. *)
