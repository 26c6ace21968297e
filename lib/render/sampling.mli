(** The sampling error of a picture: what its own samples tell of it.

    A pixel's samples are four streams that know nothing of each other. How much
    its displayed value changes when one stream is left out, and when two are,
    tells the error of the whole without assuming a distribution, and however
    samples depend on each other within a stream: the jackknife (J. W. Tukey,
    {e Bias and Confidence in Not-Quite Large Samples}, The Annals of
    Mathematical Statistics 29(2), 1958; J. Shao, C. F. J. Wu,
    {e A General Theory for Jackknife Variance Estimation}, The Annals of
    Statistics 17(3), 1989).

    Were the display linear, either would be right on average. It is not: the
    fewer samples are left, the further the curve bends between the pictures
    that are compared. To first order in the skewness of samples, leaving out a
    quarter shows 4/3, and leaving out a half twice, what the bend does to the
    true error; so J·√(J/H), for J and H the two sums, is free of it, and |J −
    H| is how far it may still be trusted. Errors are in units of 1/255. *)

type t
(** What is known of the error of some pixels. *)

val none : t
(** [none] is of no pixels. *)

val unknown : t
(** [unknown] is of a pixel that tells nothing. *)

val join : t -> t -> t
(** [join a b] is of the pixels of both. Sums depend on the order in which they
    are made, in their last bits. *)

val sum : ('a -> t) -> 'a array -> t
(** [sum f xs] is of the pixels of all [f x], joined in their order. *)

val pixel : floatarray -> int -> samples:int -> t
(** [pixel sums i ~samples] is of one pixel, whose first [samples] samples are
    summed in the {!Candor_trace.Pixel.slots} of [sums] from [i] on. *)

val squares : t -> float
(** [squares s] is what leaving out a quarter shows of the squared error, summed
    over pixels and channels, or, if that is nothing, leaving out a half: a raw
    material for {!Allocation}. *)

val mean_square : t -> float option
(** [mean_square s] is the estimate of the mean, over pixels and channels, of
    the squared error of the displayed picture before it is rounded, in units of
    (1/255)². [None] if a pixel has fewer than four samples, or one that is not
    finite. *)

val rms : t -> float option
(** [rms s] is its square root. *)

val tells_nothing : t -> bool
(** [tells_nothing s] is [true] iff a pixel has a sample that is not finite, or
    fewer than four. *)

type interval = { low : float; high : float }

val interval : confidence:float -> t -> interval option
(** [interval ~confidence s] holds the RMS error with probability [confidence],
    in \[0, 1\[: as often below as above. *)

val upper : confidence:float -> t -> float option
(** [upper ~confidence s] is at least the RMS error with probability
    [confidence]. *)

val cautious : confidence:float -> t -> float option
(** [cautious ~confidence s] is what to compare with a target that a picture is
    to stop at, if it is looked at again and again: above {!upper}, the more the
    less is known. *)
