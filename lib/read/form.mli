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

(** {1 Which words there are} *)

type words = {
  now : string list;
  later : string list;  (** words of the language that are not supported yet *)
}

val no_words : words
(** [no_words] is none, the identity of {!join}. *)

val join : words -> words -> words
(** [join a b] is the words of both. *)

val unexpected : string -> words -> string option
(** [unexpected word words] is a hint for a [word] that is none of [words]:
    which of them was meant, or what there is now, if that is not too much. *)
