(** S-expressions that know where they stand. *)

type t = { span : Span.t; node : node }

and node =
  | Atom of string
  | List of t list
      (** its span starts at the opening parenthesis and underlines the head *)

val of_parsed :
  Parsexp.Eager_and_positions.parsed_value -> (t, Span.t * string) result
(** [of_parsed p] is what parsexp has read. [Error (span, why)] where lists are
    nested more than 200,000 deep. *)

val head : t -> string option
(** [head s] is the word that the list [s] begins with. *)
