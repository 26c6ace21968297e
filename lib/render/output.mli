(** Files that are written whole or not at all. *)

type t
(** A file about to be written: a temporary one beside its target, or standard
    output. *)

val open_ : string -> (t, string) result
(** [open_ name] prepares to write [name] ([-]: standard output), so that a
    target that cannot be written is known before there is anything to write. A
    target that is not a regular file (a pipe, a device) is written to directly.
    [Error why] names the file. *)

val commit : t -> string -> (unit, string) result
(** [commit f text] writes [text] and puts it in the target's place. On
    [Error why] the target is as it was before, and nothing is left beside it.
*)

val discard : t -> unit
(** [discard f] gives up: the target is as it was before. *)

val write : string -> string -> (unit, string) result
(** [write name text] is {!open_} and {!commit}. *)
