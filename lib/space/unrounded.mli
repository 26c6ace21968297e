(** Vectors for arithmetic beyond doubles, made without rounding. *)

open Candor_number

val vec : Vec.t -> Expansion.vec
(** [vec a] is [a]. *)

val diff : Point.t -> Point.t -> Expansion.vec
(** [diff p q] is the vector from [q] to [p], exactly. *)

val pair_diff : Point.t -> Point.t -> Double_double.vec
(** [pair_diff p q] is the same, exactly too, as double-doubles. *)

val pair_near_one : Vec.t -> Double_double.vec * int
(** [pair_near_one a] is (b, e) with a = b·2^e and the largest component of [b]
    in \[1/2;1\[ either way; exact unless components differ by a factor near
    2^1000. For [a] other than zero. *)
