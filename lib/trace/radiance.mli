(** The light equation: radiance is the sum of the terms in the plan. *)

open Candor_space
open Candor_colour
open Candor_effect

type t = Tally.t -> Path.t -> Ray.t -> Rgb.t
(** The radiance that a camera ray brings along a path, in W/(m² sr). *)

val compile : Plan.equation -> t
(** [compile equation] assembles its terms once. *)
