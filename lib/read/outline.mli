(** What is open at a point of a text: parentheses, strings and comments. *)

type t

val start : bare:bool -> Span.t -> t
(** [start ~bare s] is the beginning of a text at [s]; [bare] iff no parenthesis
    is expected to enclose all of it. *)

val feed : t -> char -> t
(** [feed o c] is [o] with [c] appended. *)

val here : t -> Span.t
(** [here o] is where the next byte will stand. *)

val is_blank : t -> bool
(** [is_blank o] is [true] iff there has been nothing but white space and
    comments. *)

type unclosed =
  | Parenthesis of { opened : Span.t; doubt : int option }
      (** the innermost one, or else the first that a line, [doubt], begins not
          to the right of as if it had been closed *)
  | Quotation of Span.t
  | Comment of Span.t
  | Nothing

val unclosed : t -> unclosed
(** [unclosed o] is what a reader should be told to close. *)
