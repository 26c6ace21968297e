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

val total : t -> int
(** [total row] is how many samples its pixels have. *)

val effort : t -> int
(** [effort row] is how many rays and tests they took. *)

val squares : t -> samples:int -> int -> float
(** [squares row ~samples i] is {!Sampling.squares} of the [i]-th pixel's first
    [samples] samples, if these are 4·2{^ k}, some {!take} left the pixel with
    4·2{^ j}, j ≤ k, and it has had [samples] since. Else not a number. *)

val work : t -> int -> float
(** [work row i] is how many rays and tests each sample of the [i]-th pixel
    took, on average, of those it was given when it had fewer than four. *)

val of_part : t -> int -> Sampling.t
(** [of_part row i] is what their samples say of the error of the pixels of
    {!Part} [i]. *)

(** {1 Results} *)

type result = {
  pixels : floatarray;  (** red, green and blue of each *)
  counts : int array;  (** how many samples each has *)
  cut : floatarray;
      (** red, green and blue of the mean weight of what was cut in each *)
  parts : Sampling.t array;  (** of each {!Part}'s pixels *)
  non_finite : (int * int) option;  (** the first pixel that is *)
  tally : Tally.t;  (** of all that is done for the row, later too *)
  words : float;  (** that taking samples allocated in the minor heap *)
}

val result : t -> result
(** [result row] is what its samples say so far: a pixel without any is black.
*)

val sampling : result -> Sampling.t
(** [sampling r] is what they say of the error of the whole row. *)

val merge : t -> is_settled:(int -> bool) -> result -> result -> result
(** [merge row ~is_settled before now] has the pixels of the {!Part}s that are
    settled as the earlier result [before] has them, and all else as [now]. *)
