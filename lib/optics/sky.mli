(** What rays see that meet no surface. *)

open Candor_space
open Candor_colour
open Candor_scene

val compile : Scene.background -> Vec.t -> Rgb.t
(** [compile b] is the radiance that comes from along a direction of any length.
*)
