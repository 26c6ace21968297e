(** What parts of area lights walls hide.

    A {e wall} divides space in two and lets nothing through: an opaque sphere,
    an opaque plane without a clip box, or the inside of an opaque box, at rest.
    A straight line from a point on one side of a wall to a point on the other
    meets the wall in between: so light can reach a point directly only from
    that side of each wall that the point is on. What a light has on the other
    side may be left out of what is sampled at the point, and the mean stays
    what it is. This is shown of every point by itself ({!shields}), so that
    nothing depends on where the camera stands or what path light takes; the
    camera only says which side of each wall is worth asking about.

    A side includes the wall itself. What rounding leaves in doubt counts as
    possible: whatever is within 2^-40 of the sizes involved. *)

open Candor_space
open Candor_scene

type wall
(** A wall with one of its sides. *)

type t
(** The walls of a scene, each with the side that the camera is on. *)

val of_scene : Scene.t -> t
(** [of_scene s] are walls of [s]: 64 at most, those with the camera inside
    first. Spheres under transforms that do not keep them spheres, what
    definitions bring in, and boxes with the camera outside are not among them.
*)

val shields : wall -> departure:Ray.departure -> Point.t -> bool
(** [shields w ~departure p] is whether [p] is known to be on the side of [w]:
    well inside it, or on the wall itself, which [departure] then is, with that
    side. *)

(** What of a sphere is on one side of a wall. *)
type part =
  | Whole  (** all of it, for all that is known *)
  | Cap of { axis : Dir.t; one_minus_cos : float }
      (** nothing but what is within this angle of [axis], seen from the centre;
          [one_minus_cos] in \]0;2\[ *)
  | Nothing  (** none of it *)

val part : wall -> center:Point.t -> radius:float -> part
(** [part w ~center ~radius] is what of that sphere is on the side of [w],
    rounded outwards. *)

val best : t -> center:Point.t -> radius:float -> (wall * part) option
(** [best t ~center ~radius] is the wall of [t] that leaves least of that
    sphere, with the {!part} left; [None] if none takes any of it. *)

val beyond : t -> Point.t list -> wall option
(** [beyond t points] is a wall of [t] that has nothing of the convex hull of
    [points] on its side, if there is one. *)
