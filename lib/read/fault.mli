(** Why a text could not be read to its end. *)

type t = {
  span : Span.t option;  (** [None] where no text could be read *)
  message : string;
  hint : string option;
  distrust : int;
      (** what begins at or after this offset may not be what was meant *)
}

val v : ?hint:string -> Span.t -> string -> t
(** [v span message] is a fault that leaves what was read before it intact. *)

val unreadable : string -> t
(** [unreadable why] is the fault of a file that gave no text. *)

val of_parser : Parsexp.Parse_error.t -> t
(** [of_parser e] says [e] in our words. *)

val closes_nothing : Parsexp.Parse_error.t -> bool
(** [closes_nothing e] is [true] iff [e] is a [)] without an opening one. *)

val unclosed : Source.t -> bare:bool -> Span.t -> otherwise:t -> t
(** [unclosed s ~bare start ~otherwise] is what is left open at the end of [s],
    which is read again from [start]; [otherwise] if that finds nothing. For
    [bare], see {!Outline.start}. *)
