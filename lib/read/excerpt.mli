(** The line of a text that an error is about. *)

type t = {
  text : string;  (** at most 76 columns, on one line, printable *)
  indent : int;  (** columns before what is meant *)
  width : int;  (** columns of what is meant, at least 1 *)
}

val of_source : Source.t -> Span.t -> t option
(** [of_source s span] shows the line of [span] in [s], or, where that is long,
    the part of it around what [span] underlines, with [...] for the rest;
    [None] if the line is empty, or gone. *)
