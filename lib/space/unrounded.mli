(** Vectors for arithmetic beyond doubles, made without rounding. *)

open Candor_number

val vec : Vec.t -> Expansion.vec
(** [vec a] is [a]. *)

val diff : Point.t -> Point.t -> Expansion.vec
(** [diff p q] is the vector from [q] to [p], exactly. *)

val pair_diff : Point.t -> Point.t -> Double_double.vec
(** [pair_diff p q] is the same, exactly too, as double-doubles. *)

val diff_error : Point.t -> Point.t -> Vec.t -> Vec.t
(** [diff_error p q d] is what [d = Point.sub p q] is off by, exactly. *)
