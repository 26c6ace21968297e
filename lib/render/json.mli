(** JSON values, for statistics that programs read. *)

type t =
  | Null
  | Bool of bool
  | Int of int
  | Float of float
  | String of string
  | List of t list
  | Object of (string * t) list

val to_string : t -> string
(** [to_string j] is [j] as JSON text (RFC 8259) in indented lines, ending in a
    newline. Numbers that JSON cannot write (infinite, [nan]) become [null]. *)
