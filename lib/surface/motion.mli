(** Steady motion along a line while the camera's shutter is open. *)

open Candor_space

type t

val v : velocity:Vec.t -> shutter:float * float -> t
(** [v ~velocity ~shutter] moves by [velocity] per unit of time, between the two
    times of [shutter], both included, in either order. *)

val displacement : t -> float -> Vec.t
(** [displacement m time] is how far [m] has moved at [time]: time·velocity,
    each component rounded once. That vector of doubles is what the motion is.
*)

val sweep : t -> Bounds.t -> Bounds.t
(** [sweep m b] is a box that holds [b] wherever [m] takes it while the shutter
    is open; [b] itself along every axis that it does not move along. *)

(** {1 Displacements as maps} *)

val map : Vec.t -> Wide_affine.t
(** [map d] moves by [d]. *)

val follow : Vec.t -> Object_ray.t -> Object_ray.t
(** [follow d r] is [r] as seen by what has moved by [d]. *)
