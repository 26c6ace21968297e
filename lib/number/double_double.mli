(** Numbers of about 106 bits: unevaluated sums of two doubles.

    The rare second tier of the intersection tests. Errors are relative, with u
    = 2^-53, as proved by M. Joldes, J.-M. Muller, V. Popescu,
    {e Tight and Rigorous Error Bounds for Basic Building Blocks of Double-Word
       Arithmetic}, ACM TOMS 44(2), 2017. *)

type t = Error_free.t
(** The value hi + lo. *)

val of_float : float -> t
(** [of_float x] is [x] exactly. *)

val add : t -> t -> t
(** [add a b] is [a + b] within 3u² + 13u³. *)

val sub : t -> t -> t
(** [sub a b] is [a - b], likewise. *)

val mul : t -> t -> t
(** [mul a b] is [a·b] within 5u². *)

val scale : float -> t -> t
(** [scale k a] is [k·a] within 2u². *)

val div : t -> t -> t
(** [div a b] is [a/b] within 15u². *)

val neg : t -> t
(** [neg a] is [-a] exactly. *)

val to_float : t -> float
(** [to_float a] is the double nearest to [a]. *)

(** {1 Vectors} *)

type vec = { x : t; y : t; z : t }

val dot : vec -> vec -> t
(** [dot a b] is the scalar product; its error is relative to the sum of the
    absolute products. *)
