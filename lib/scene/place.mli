(** Places in the source of a scene. *)

type t = { file : string; line : int; column : int } [@@deriving show, eq, ord]
(** A file as named by the user or an [include]; lines and columns count from 1.
*)

val unknown : t
(** [unknown] is the place of what no file says: a default. *)

val to_string : t -> string
(** [to_string p] is [file:line:column], as compilers write it. *)
