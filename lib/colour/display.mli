(** From linear light to the numbers in an 8-bit picture, as smallpt (K. Beason,
    {e smallpt: Global Illumination in 99 lines of C++}, 2008) does it: clamp to
    \[0;1\], raise to the power 1/2.2, times 255, add a half and truncate. *)

val encode : float -> float
(** [encode x] is the displayed value of linear [x] in units of 1/255, before
    rounding: 255 · clamp(x)^(1/2.2), in \[0;255\]. A [nan] encodes as 0; who
    calls it counts non-finite values before. *)

val nearest : float -> int
(** [nearest v] is the integer nearest to the displayed value [v], in \[0;255\],
    half up. *)

val level : float -> int
(** [level x] is [encode x] rounded to the nearest integer, half up; in
    \[0;255\]. *)

val decode : int -> float
(** [decode n] is (n/255)^2.2, the linear value that displays as [n].
    [level (decode n) = n] for [n] in \[0;255\]. *)
