(** How often an event of probability p happens in n independent trials.

    [n] is at most 2^39 and [0 <= successes <= n]; else all is [nan]. *)

val test : successes:int -> int -> float -> float
(** [test ~successes n p] is the exact two-sided test that each of [n] trials
    succeeds with probability [p]: twice the probability of at most, or of at
    least, so many [successes], whichever is less, but never above 1. If the
    hypothesis holds, it is at most α with probability at most α. Its relative
    error is at most (4 + |ln test|)·(1 + √n/16)·2^-50; [nan] unless [p] is in
    \[0, 1\]. *)

val interval : confidence:float -> successes:int -> int -> float * float
(** [interval ~confidence ~successes n] is the least and the greatest
    probability that {!test} does not reject at level 1 − [confidence]: it holds
    the true one with probability [confidence] at least. After C. J. Clopper, E.
    S. Pearson,
    {e The Use of Confidence or Fiducial Limits Illustrated in the Case of the
       Binomial}, Biometrika 26(4), 1934. Both, and their distances from 1 where
    those are doubles, are within a relative 2^-46; [nan] unless [confidence] is
    in \[0, 1\]. *)
