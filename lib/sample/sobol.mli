(** Numbers that fill an interval or a square evenly, however many are taken.

    The points are those of the (0,2)-sequence of I. M. Sobol, their indices
    shuffled and their digits scrambled in the nested way of A. B. Owen, both by
    hashes of a key, after B. Burley, {e Practical Hash-based Owen Scrambling},
    JCGT 9(4), 2020, with the hash of N. Vegdahl, {e Building a Better LK Hash},
    2021.

    Points i·2^k … (i+1)·2^k − 1 of one key share the square out: each of the
    2^k boxes of any grid of 2^a × 2^b boxes, a + b = k, holds exactly one. Each
    point by itself is uniform over keys. Points of the same index and different
    keys have nothing to do with each other: so each purpose that numbers serve
    has its own key, and the index is that of the sample.

    An index is in 0 … 2^32 − 1; of others only the low 32 bits count. Results
    are in \[0;1\[, multiples of 2^-53. *)

val pair : key:Key.t -> int -> Pattern.position
(** [pair ~key i] is point [i] of the square that [key] names. *)

val one : key:Key.t -> int -> float
(** [one ~key i] is point [i] of the interval that [key] names, the [u] of
    [pair ~key i]: of points i·2^k … (i+1)·2^k − 1 each of 2^k equal intervals
    holds exactly one. *)
