(** Lists that begin with a word, and how messages speak of them. *)

type t = { head : string; span : Span.t; body : Located.t list }
(** The form [(head body...)]; [head] is [""] in lists without one, such as the
    corners of a triangle. *)

val of_located : Located.t -> t option
(** [of_located s] is [s] as a form, if it begins with a word. *)

val title : string -> string
(** [title head] is ["(head ...)"]. *)

val synopsis : string -> string -> string
(** [synopsis head arguments] is ["(head arguments)"]. *)

val quote : Located.t -> string
(** [quote s] is [s] in short. *)

val found : t -> string
(** [found f] says how much there is in the body of [f]. *)

val unexpected : string -> among:string list -> string option
(** [unexpected word ~among] is a hint for a [word] that is none of those
    [among] which one is expected: which of them was meant, or all of them, if
    they are not too many. *)
