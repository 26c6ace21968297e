(** The top-level forms of a text, one after the other. *)

val iter :
  Source.t -> bare:bool -> (Located.t -> unit) -> (Span.t, Fault.t) result
(** [iter s ~bare f] reads [s] and applies [f] to each of its forms as soon as
    it is complete, so that only one of them is in memory at a time. The forms
    stand within [(scene ...)], or, if [bare], for themselves. The result is
    where the word [scene] stands; if [bare], where the text begins. *)
