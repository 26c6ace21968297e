(** The light equation: radiance is the sum of the terms in the plan. *)

open Candor_space
open Candor_colour
open Candor_scene
open Candor_surface
open Candor_effect

val compile :
  Plan.t -> Scene.t -> Assembly.skin Surface.t -> Tally.t -> Ray.t -> Rgb.t
(** [compile plan scene surface] assembles the terms once; the result is the
    radiance that a camera ray brings, in W/(m² sr). *)
