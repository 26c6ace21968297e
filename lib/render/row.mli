(** A row of pixels while its samples are taken. Only {!take} changes it: one
    domain at a time. *)

open Candor_effect
open Candor_trace

type t

val make : x0:int -> x1:int -> int -> t
(** [make ~x0 ~x1 y] is the pixels x0 ≤ x < x1 of row [y], without samples. *)

val width : t -> int

val take : Pixel.t -> t -> (int -> int) -> unit
(** [take p row f] gives the [i]-th pixel its first [f i] samples, if it has
    less. *)

val samples : t -> int -> int
(** [samples row i] is how many samples the [i]-th pixel has. *)

val total : t -> int
(** [total row] is how many samples its pixels have. *)

val sampling : t -> int -> Sampling.t
(** [sampling row i] is what they say of the [i]-th pixel's error. *)

type result = {
  pixels : floatarray;  (** red, green and blue of each *)
  counts : int array;  (** how many samples each has *)
  cut : floatarray;
      (** red, green and blue of the mean weight of what was cut in each *)
  sampling : Sampling.t;
  non_finite : (int * int) option;  (** the first pixel that is *)
  tally : Tally.t;  (** of all that was done *)
  words : float;  (** that taking samples allocated in the minor heap *)
}

val result : t -> result
(** [result row] is what its samples, at least one for each pixel, say so far.
*)
