(** Where samples lower the error of a picture most.

    The mean square error of a picture is a sum over pixels of v / n^β, n the
    pixel's number of samples, and what they cost is a sum of c·n: for a given
    cost it is least when n goes as √(v/c) (for β = 1; J. Neyman,
    {e On the Two Different Aspects of the Representative Method}, Journal of
    the Royal Statistical Society 97(4), 1934).

    What a pixel's error is, the advisers of its {!Part} say, who are believed
    as far as both halves of them agree. They tell how the samples of a part are
    shared out among its pixels; how many these are together is for the caller
    to say ({!for_mean}). *)

type t

val make :
  Window.t ->
  base:int ->
  cost:(int -> int -> float) ->
  (int -> int -> float) ->
  t
(** [make window ~base ~cost f]: [f x y] is the squared error that [base]
    samples leave in pixel (x, y) of the window, [cost x y] > 0 what one more of
    them costs; an error that is not finite counts as 0. *)

val samples : t -> scale:float -> most:int -> int -> int -> int
(** [samples a ~scale ~most x y] is what pixel (x, y) should have: [base] at
    least, [most] at most, no fewer for a greater [scale]. It is [base] times a
    power of two, or [most]: of the two nearest one at random, by the pixel's
    place. *)

val base : t -> int
(** [base a] is what each pixel has. *)

val with_base : t -> int -> t
(** [with_base a n] is [a] with [n] samples for each pixel, above [base a], and
    the same shares beyond: its {!error} is a share of what [n] samples leave.
*)

val work : t -> float
(** [work a] is what a sample beyond the base costs, on average, about. *)

(** {1 Together} *)

(** Of which pixels: *)
type part = All | Part of int

val mean : t -> part -> scale:float -> most:int -> float
(** [mean a part ~scale ~most] is how many samples that makes for each pixel of
    the part, on average, about. *)

val error : t -> law:float -> scale:float -> most:int -> float
(** [error a ~law ~scale ~most] is the mean square error that they leave in all
    pixels, as a share of the one that {!base} samples leave. [law] is β. *)

val for_mean : t -> part -> most:int -> float -> float
(** [for_mean a part ~most n] is the scale whose {!mean} is [n], or the greatest
    that changes anything. *)

val for_error : t -> law:float -> most:int -> float -> float
(** [for_error a ~law ~most share] is the scale whose {!error} is [share], or
    the greatest that changes anything. *)
