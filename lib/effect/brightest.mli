(** The greatest radiance that any path can find in a scene, however long it is:
    what bounds the light that is lost where paths are cut.

    A point of a surface, or of a medium, sends on what it adds of itself, at
    most [s], and a part of the light that comes to it, at most [k]: it cannot
    be brighter than L if nothing else is and s + k·L ≤ L. So nothing is
    brighter than the background and the greatest s / (1 − k), by induction over
    the length of paths; and where s is 0 a point may pass on all it gets. Each
    colour has its own s, k and L.

    What is added is emission, the ambient light's part, and the light of
    lights. Of point and spot lights that dwindle with distance, the irradiance
    is bounded by how near they come to surfaces ({!Nearness}); of area lights,
    for a direction shows one of them at most, a matte surface sees no more
    irradiance than π times their greatest radiance. The bound speaks of
    radiance, thus of the mean of samples; one sample that is left to chance may
    be above. It holds up to rounding. *)

open Candor_colour
open Candor_scene

type t =
  | At_most of Rgb.t  (** radiance, by colour *)
  | Unbounded of string  (** no bound is known, and why; with a place *)
[@@deriving show, eq]

val of_scene : Scene.t -> t
(** [of_scene s] bounds what paths find in [s], with all that it asks for and
    without any limit to their depth. Where lights dwindle with distance it
    takes as long as putting the surfaces together; else it is quick. *)
