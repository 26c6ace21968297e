(** Where samples lower the error of a picture most.

    The mean square error of a picture is a sum over pixels of v / n^β, n the
    pixel's number of samples: for a given number of samples it is least when n
    goes as √v (for β = 1; J. Neyman,
    {e On the Two Different Aspects of the Representative Method}, Journal of
    the Royal Statistical Society 97(4), 1934).

    Each pixel is given as many samples as its neighbours ask for, itself left
    out: so how many it has tells nothing of what they are, and their mean is
    right on average. *)

type t

val make : width:int -> height:int -> base:int -> (int -> int -> float) -> t
(** [make ~width ~height ~base f]: every pixel has [base] samples, [f x y] is
    the squared error that this leaves in pixel (x, y); what is not finite
    counts as 0. *)

val samples : t -> scale:float -> most:int -> int -> int -> int
(** [samples a ~scale ~most x y] is what pixel (x, y) should have: [base] at
    least, [most] at most, more for a greater [scale]. It is [base] times a
    power of two, or [most]: of the two nearest one at random, by the pixel's
    place. *)

val total : t -> scale:float -> most:int -> float
(** [total a ~scale ~most] is how many samples that makes for all pixels, about.
*)

val error : t -> law:float -> scale:float -> most:int -> float
(** [error a ~law ~scale ~most] is the mean square error that they leave, as a
    share of the one that [base] samples leave. [law] is β. *)

val for_error : t -> law:float -> most:int -> float -> float
(** [for_error a ~law ~most share] is the scale whose {!error} is [share], or
    the greatest that changes anything. *)

val for_total : t -> most:int -> float -> float
(** [for_total a ~most n] is the scale whose {!total} is [n], or the greatest
    that changes anything. *)
