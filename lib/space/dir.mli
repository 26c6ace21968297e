(** Unit directions. *)

type t = private Vec.t [@@deriving show, eq, ord]
(** A vector of length 1 up to rounding (within 2^-51). Read it as a vector with
    [(d :> Vec.t)], which costs nothing. *)

val of_vec : Vec.t -> t option
(** [of_vec a] is [a] divided by its length, whatever its size; [None] if [a] is
    zero or not finite. *)

val of_vec_or : t -> Vec.t -> t
(** [of_vec_or d a] is [of_vec a], or [d] where that is [None]. *)

val x : t
(** [x] is the first axis. *)

val y : t
(** [y] is the second axis. *)

val z : t
(** [z] is the third axis. *)

val neg : t -> t
(** [neg d] is the opposite direction. *)

val dot : t -> t -> float
(** [dot a b] is the cosine of the angle between [a] and [b], up to rounding: it
    may leave \[-1;1\] by 2^-50. *)
