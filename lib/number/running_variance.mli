(** Means and variances of samples that come one by one, or in parts.

    After B. P. Welford,
    {e Note on a Method for Calculating Corrected Sums of Squares and Products},
    Technometrics 4(3), 1962, and for parts T. F. Chan, G. H. Golub, R. J.
    LeVeque,
    {e Algorithms for Computing the Sample Variance: Analysis and
       Recommendations}, The American Statistician 37(3), 1983; but the mean is
    held in twice the precision, so that it may be as far from 0 as it likes:
    the error does not grow with the ratio of mean to spread, until that ratio
    comes near 2^50, where the samples themselves have no bits left.

    Sums and squares of samples must stay within the range of doubles; samples
    that are not finite make the mean and the variance [nan]. *)

type t
(** What is known of the samples so far. *)

val empty : t
(** [empty] is no samples. *)

val add : t -> float -> t
(** [add v x] is [v] and the sample [x]. *)

val join : t -> t -> t
(** [join a b] is the samples of both. *)

val count : t -> int
(** [count v] is the number of samples. *)

val mean : t -> float option
(** [mean v] is their mean; [None] of no samples. *)

val variance : t -> float option
(** [variance v] is the unbiased estimate of the variance of what the samples
    were drawn from: Σ(x − mean)²/(n − 1), never negative, 0 for equal samples;
    [None] of fewer than two. Its relative error is at most (n + 16)·2^-51. *)
