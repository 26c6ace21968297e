(** Numbers as people write them: as many digits as say something, with the
    signs − and ∞, and — for what is not a number. Units stand behind a space
    that does not break. *)

val number : float -> string
(** [number x] is [x] in three digits or so. *)

val seconds : float -> string
(** [seconds s] is a time in two digits or so, with its unit, from µs to days.
*)

val range : float -> float -> string
(** [range low high] is both times, such as [12 to 17 s]. *)

val error : float -> string
(** [error e] is an error in units of 1/255: [number], but [<0.001] for all that
    is nearer to 0. *)

val target : float -> string
(** [target e] is a round number as short as it can be, such as [4] and [½]. *)

val change : (float -> string) -> float -> string
(** [change show d] is [show] of [d] with its sign, + or −, where it has digits
    to sign. *)

val percent : float -> string
(** [percent share] is a share of 1, such as [12 %]. *)

val count : int -> string -> string
(** [count n noun] is [n noun], with an s at the end unless [n] is 1. *)

val whole : int -> string
(** [whole n] is [n], its digits in groups of three. *)
