(** Invertible affine maps, made of the steps that a scene writes down. *)

type step =
  | Translate of Vec.t  (** moves by this vector *)
  | Scale of Vec.t  (** multiplies the coordinates by these three numbers *)
  | Rotate of { axis : Vec.t; degrees : float }
      (** turns about an axis through the origin, counter-clockwise seen against
          it *)
  | Matrix of Affine.t  (** any affine map *)
[@@deriving show, eq, ord]

type t
(** A map with its inverse: each step's own doubles, exactly, the inverse of
    each as near as pairs of doubles come, and all of them composed in pairs of
    doubles. *)

val identity : t

val of_steps : step list -> (t, string) result
(** [of_steps s] is the map that takes the steps of [s] in order, the first
    first. [Error why] if a step, or all together, cannot be undone: a scale by
    zero, a rotation about no axis, a singular matrix, or numbers that overflow.
*)

val forward : t -> Wide_affine.t
(** [forward m] takes points from inside to outside. *)

val backward : t -> Wide_affine.t
(** [backward m] undoes [forward m]. *)

val after : t -> t -> t
(** [after b a] does [a] first, then [b]. *)
