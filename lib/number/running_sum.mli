(** Sums of any number of terms, right to the last bit.

    Each step keeps what rounding the sum lost and joins it to the sum again, so
    that this correction stays below a unit in the last place however many terms
    there are. After the addition of a double to a double-double in M. Joldes,
    J.-M. Muller, V. Popescu,
    {e Tight and Rigorous Error Bounds for Basic Building Blocks of Double-Word
       Arithmetic}, ACM TOMS 44(2), 2017. *)

type t
(** The sum of the terms so far, in about 106 bits. *)

val zero : t
(** [zero] is the sum of no terms. *)

val add : t -> float -> t
(** [add s x] is [s + x], off by at most 2^-105 times the result. *)

val join : t -> t -> t
(** [join a b] is the sum of the terms of both, off by at most 2^-104 times the
    result. *)

val total : t -> float
(** [total s] is the sum as a double: off by at most half a unit in its last
    place and, after n steps, n·2^-104 times the sum of the absolute terms. That
    is less than one unit for 10^9 terms of one sign. As in plain addition,
    infinities make an infinity or [nan], and [nan] stays. *)

(** {1 In place} *)

val accumulate : floatarray -> int -> float -> unit
(** [accumulate a i x] is {!add} of [x] to the sum that slots [i] and [i + 1] of
    [a] hold; zeros hold {!zero}. It does not allocate. *)

val held : floatarray -> int -> t
(** [held a i] is the sum that slots [i] and [i + 1] of [a] hold. *)
