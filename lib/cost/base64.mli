(** Bytes as text (S. Josefsson, {e RFC 4648}, 2006, 4). *)

val encode : string -> string
(** [encode bytes] is [bytes] in base 64, with padding. *)
