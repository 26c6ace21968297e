(** The directions from a point in which an area light may be met, and how to
    choose among them.

    A target holds the whole light, or all of it that matters, and is as close
    around it as its shape allows. Nothing here depends on the unit of length:
    multiplying all lengths by a power of two leaves the bits. Solid angles are
    in steradians, densities per steradian. *)

open Candor_space
open Candor_sample
open Candor_scene

type t

val of_primitive : Primitives.t -> t
(** [of_primitive p] is the target for the light of [p] at time 0, with sides as
    [p.both_sides] says:
    - a sphere, where its transform keeps it one: itself;
    - a triangle or a flat box: itself; a box: its faces;
    - a sphere under another transform, or an ellipsoid without a clip box:
      itself, as {!Ellipsoid_target} has it;
    - another quadric: the box around it (for a plane across an axis, its
      rectangle), as transformed.

    Unbounded quadrics have no target: from nowhere is anything of theirs seen.
*)

val cap : axis:Dir.t -> one_minus_cos:float -> t -> t
(** [cap ~axis ~one_minus_cos t] is the part of a sphere that emits outwards
    only, where directions from its centre are within the angle of this cosine
    from [axis]; [one_minus_cos] in \]0;2\]. Of other targets it is [t]. *)

type sample = Ellipsoid_target.sample = {
  direction : Dir.t;
  density : float;  (** above 0, finite; [density t ~from direction] *)
}

val sample : t -> from:Point.t -> Pattern.position -> sample option
(** [sample t ~from p] takes uniform [p] in \[0;1\[² to a direction to [t]:
    uniform over all in which [t] is seen from its emitting side (for an
    ellipsoid nearly so); for a {!cap}, towards points uniform over its area.
    From within a box that only stands for what is in it, all directions are
    taken. [None] where nothing is seen. *)

val density : t -> from:Point.t -> Dir.t -> float
(** [density t ~from d] is the density with which [sample t ~from] takes [d]; 0
    where it never does. *)

val solid_angle : t -> from:Point.t -> float
(** [solid_angle t ~from] is the solid angle of the directions that
    [sample t ~from] takes, in \[0;4π\]; for a {!cap} that of the least ball
    around its middle that holds it, which is no less. It is 0 only where
    [sample] is [None], up to rounding. *)

(** {1 Asking twice from one point} *)

type look
(** What {!sample} and {!solid_angle} have in common; much of the work of both
    where the target is flat. *)

val is_flat : t -> bool
(** [is_flat t] is whether [look t] is more than nothing. *)

val look : t -> from:Point.t -> look
(** [look t ~from] is [t] as seen from that point. *)

val nothing : look
(** [nothing] is every look at a target that is not flat. *)

val sample_seen : look -> t -> from:Point.t -> Pattern.position -> sample option
(** [sample_seen (look t ~from) t ~from p] is [sample t ~from p]. *)

val solid_angle_seen : look -> t -> from:Point.t -> float
(** [solid_angle_seen (look t ~from) t ~from] is [solid_angle t ~from]. *)

(** {1 Extent} *)

val area : t -> float
(** [area t] is the area of the target, one side of it; for an ellipsoid up to
    2/√3 of that. *)

val corners : t -> Point.t list
(** [corners t] are points whose convex hull holds the target. *)

val ball : t -> (Point.t * float) option
(** [ball t] is the centre and the radius of a target that is a sphere. *)
