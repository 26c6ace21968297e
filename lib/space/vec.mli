(** Vectors: directions and displacements, in scene units. *)

type t = { x : float; y : float; z : float } [@@deriving show, eq, ord]

val v : float -> float -> float -> t
(** [v x y z] is the vector with these components. *)

val zero : t
(** [zero] is [v 0. 0. 0.]. *)

val neg : t -> t
(** [neg a] is [-a]. *)

val add : t -> t -> t
(** [add a b] is [a + b]. *)

val sub : t -> t -> t
(** [sub a b] is [a - b]. *)

val scale : float -> t -> t
(** [scale k a] is [k·a]. *)

val along : t -> t -> float -> t
(** [along a d t] is [a + t·d], each component rounded once. *)

val ldexp : int -> t -> t
(** [ldexp e a] is a·2^e, exact unless it leaves the range of doubles. *)

val dot : t -> t -> float
(** [dot a b] is the scalar product. *)

val cross : t -> t -> t
(** [cross a b] is the vector product, right-handed. [cross b a] is exactly
    [neg (cross a b)]. *)

val has_plain_square : float -> bool
(** [has_plain_square (dot a a)] is [true] only if [a] is finite, not zero, and
    its largest component in \]2^-400;2^400\[: [norm a] is the root of that
    then. *)

val norm : t -> float
(** [norm a] is the Euclidean length, without overflow or underflow on the way.
*)

val abs : t -> t
(** [abs a] has the absolute components of [a]. *)

val norm1 : t -> float
(** [norm1 a] is the sum of the absolute components. *)

val largest : t -> float
(** [largest a] is the greatest of the absolute components. *)

val exponent : t -> int
(** [exponent a] is the least e with [largest a] < 2^e; 0 if that is 0 or not
    finite. *)

val is_finite : t -> bool
(** [is_finite a] is [true] iff no component is infinite or not a number. *)

val get : t -> int -> float
(** [get a i] is component [i] of [0], [1], [2] (any other [i] counts as [2]).
*)
