(** A setting measured twice, with sets of samples that are independent of each
    other: so that their difference tells how noisy they are, and errors can be
    told from noise.

    All measures are of the displayed picture before rounding, over all channels
    of the subset's pixels, in units of 1/255. Pairs that are put beside each
    other are of one subset and have the same two seeds, their first the one and
    their second the other. *)

open Candor_image

type t = { first : Measure.t; second : Measure.t }

val seconds : t -> float
(** [seconds p] is the mean of both, for the whole picture. *)

val rays_per_pixel : t -> float

val count : t -> int
(** [count p] is the number of pixels. *)

(** {1 Errors} *)

type error = {
  rms : float;
  p99 : float;  (** the 99th percentile of the pixels' errors *)
  pixels : Plane.t;  (** each pixel's error *)
}

val error : finest:t -> t -> error
(** [error ~finest p] is the error of one of [p]'s sets beside the truth.
    [finest] stands for that: the first of [p] is compared with the second of
    [finest] and the other way round, which are independent, so that the mean
    square of the noise of [finest], known from the difference of its halves, is
    to be subtracted. It is unbiased for mean squares. Percentiles and pixels
    have the noise of [finest] taken off in the same proportion as the whole.
    [finest] is itself a possible [p]. *)

val spread : t -> floatarray
(** [spread p] is each pixel's variance, estimated from its two values. *)

(** {1 Changes} *)

type change = {
  equal : bool;  (** every pixel has the same bits, in both sets *)
  loss : float;
      (** the root mean square of what changes in the mean, at least 0 *)
  bound : float;  (** what [loss] is below with a confidence of .95 at least *)
  noisier : bool;  (** whether noise grows beyond chance *)
  quieter : bool;  (** whether it shrinks *)
  shows : bool;  (** whether the mean changes beyond chance, or noise grows *)
}

val change : base:t -> t -> change
(** [change ~base p] is how [p] differs from [base]. What the two sets both see
    of a difference is no noise: the mean product of the differences in one and
    in the other estimates the mean square of the true one without bias. [shows]
    asks five tests, of linear light but for the last, each at level .001, over
    the pixels: whether that mean product is positive; whether the mean of a
    channel (three of them) changes; and whether the variance grows (or shrinks:
    a sixth). *)

val wrong : base:t -> t -> int
(** [wrong ~base p] counts the pixels that are off by a level or more, the same
    way in both sets, in some channel. *)
