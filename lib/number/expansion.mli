(** Exact arithmetic on sums of doubles, for the rare tests that plain doubles
    cannot decide.

    After J. R. Shewchuk,
    {e Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
       Predicates}, Discrete & Computational Geometry 18, 1997. Results are
    exact as long as nothing overflows and no product's error falls below
    2^-1074. *)

type t
(** A real number that is a finite sum of doubles. *)

val of_float : float -> t
val add : t -> t -> t
val sub : t -> t -> t
val mul : t -> t -> t
val neg : t -> t

val diff : float -> float -> t
(** [diff a b] is [a - b] exactly. *)

val shift : int -> t -> t
(** [shift e a] is [a·2^e], exact unless it leaves the range of doubles. *)

val sign : t -> int
(** [sign x] is -1, 0 or 1. *)

val to_float : t -> float
(** [to_float x] is [x] within one unit in the last place. *)

val to_pair : t -> Error_free.t
(** [to_pair x] is [x] as near as a sum of two doubles comes, within 2^-104. *)

val ratio : t -> t -> float
(** [ratio x y] is [x/y] within two units in the last place; [nan] or infinite
    where [y] is zero. *)

val ratio_pair : t -> t -> Error_free.t
(** [ratio_pair x y] is [x/y] within 2^-102 of it; [nan] or infinite where [y]
    is zero. *)

(** {1 Vectors} *)

type vec = { x : t; y : t; z : t }

val dot : vec -> vec -> t
val cross : vec -> vec -> vec
