(** What queries have cost, counted. Queries add to it and never read it. *)

type t

val make : unit -> t
(** [make ()] is no effort so far. *)

val add : Cursor.t -> t -> unit
(** [add cursor e] adds what [cursor]'s query has done. *)

val tests : t -> int
(** [tests e] is how many times a ray was tested against a surface. *)

val careful : t -> int
(** [careful e] is in how many of them plain doubles did not do. *)

val sum : t list -> t
(** [sum es] is all of [es] together. *)
