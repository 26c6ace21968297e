(** The normal distribution of mean 0 and variance 1. *)

val cdf : float -> float
(** [cdf x] is the probability of at most [x], within a relative 2^-50 where it
    is at least 2^-1022; below x ≈ -38.6 it is 0. The tail above [x] is
    [cdf (-.x)]. *)

val quantile : float -> float
(** [quantile p] is the x for which [cdf x] is [p], within a relative 2^-50; -∞
    at 0, ∞ at 1, [nan] outside \[0, 1\]. [quantile (1 − p)] is [−quantile p],
    to the bit if 1 − p is exact.

    After M. J. Wichura,
    {e Algorithm AS 241: The Percentage Points of the Normal Distribution},
    Applied Statistics 37(3), 1988. *)
