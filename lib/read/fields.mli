(** Bodies of fields: forms in any order, each with its head.

    The reader of a body says in one line per field what it is called and how it
    is read:
    {[
    let sphere =
      fields
        (let+ center = field "center" point
         and+ radius = field "radius" radius in
         (center, radius))
    ]}
    Fields that it does not name are errors. *)

open Decode

type 'a fields
(** How to read a body of fields as an ['a]. *)

val fields : 'a fields -> 'a body
(** [fields f] is the fields in [f] and no others. *)

val ( let+ ) : 'a fields -> ('a -> 'b) -> 'b fields
val ( and+ ) : 'a fields -> 'b fields -> ('a * 'b) fields

val nothing : unit fields
(** [nothing] is no field at all. *)

val field : string -> 'a body -> 'a fields
(** [field head b] is the form [head], which must be there, once. *)

val optional : string -> 'a body -> 'a option fields
(** [optional head b] is the form [head], if it is there. *)

val default : string -> 'a body -> 'a -> 'a fields
(** [default head b x] is the form [head], or [x] without it. *)

val present : string -> bool fields
(** [present head] is [true] iff the form [(head)] is there. *)

val items : 'a value -> 'a list fields
(** [items v] is everything that looks like a [v], in order. *)

val item : string -> 'a value -> 'a fields
(** [item what v] is the only thing that looks like a [v], which must be there;
    errors call it [what]. *)
