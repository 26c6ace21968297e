(** Where something stands in a text. *)

type t = {
  line : int;  (** counts from 1 *)
  column : int;  (** counts bytes from 1 *)
  offset : int;  (** bytes before it in the text *)
  mark : int;  (** bytes from there to what an excerpt underlines *)
  width : int;  (** bytes to underline, at least 1 *)
}

val start : t
(** [start] is the first byte of a text. *)

val after : t -> char -> t
(** [after s c] is the byte that follows, where [c] is the one at [s]. *)

val of_position : Parsexp.Positions.pos -> t
(** [of_position p] is the byte at [p]. *)

val to_position : t -> Parsexp.Positions.pos
(** [to_position s] is where [s] starts. *)

val to_string : t -> string
(** [to_string s] is [line:column]. *)
