(** Rays as surfaces see them: in the space of the groups around, held as sums
    of two doubles. *)

open Candor_number

type t = private {
  origin : Point.t;
  direction : Vec.t;
  origin_low : Vec.t;
  direction_low : Vec.t;
  exact : bool;  (** whether both low parts are zero *)
}
(** The points (origin + origin_low) + t·(direction + direction_low). A low part
    is at most half an ulp of what it belongs to. [t] is the same in all spaces.
*)

val of_ray : Ray.t -> t
(** [of_ray r] is [r] in its own space. *)

val v : Point.t -> Vec.t -> t
(** [v o d] is the ray from [o] along [d], as given. *)

val through : Wide_affine.t -> t -> t
(** [through m r] is the image of [r] under [m]; each coordinate within 2^-100
    of the sum of the absolute products it is made of. *)

val ldexp : length:int -> time:int -> t -> t
(** [ldexp ~length ~time r] has its origin multiplied by 2^length, its direction
    by 2^time. *)

(** {1 Seen from a point} *)

val from : t -> Point.t -> Expansion.vec
(** [from r p] is the vector from [p] to the origin of [r], exactly. *)

val toward : t -> Expansion.vec
(** [toward r] is the direction, exactly. *)

val offset : t -> Point.t -> Vec.t * Vec.t
(** [offset r p] is {!from} as a vector and what is left beside it, which is off
    by 2^-53 of itself. *)

val closest : t -> Point.t -> Vec.t
(** [closest r p] is the vector from [p] to the point of [r]'s line nearest to
    [p], within 2^-50 of its length and 2^-100 of the distance from [p] to the
    origin. *)

val near_one : t -> t * int
(** [near_one r] is (r', e): [r] with its direction times 2^-e, the largest
    component of which is then in \[1/2;1\[ either way. *)

val pair_from : t -> Point.t -> Double_double.vec
(** [pair_from r p] is {!from} rounded to double-doubles; exact if [r] is. *)

val pair_near_one : t -> Double_double.vec * int
(** [pair_near_one r] is (b, e) with the direction b·2^e and the largest
    component of [b] in \[1/2;1\[ either way; exact unless components differ by
    a factor near 2^1000. *)
