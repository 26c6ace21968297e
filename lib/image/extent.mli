(** How large a picture a file may declare.

    Every decoder asks here before it allocates, so that a small broken file
    cannot ask for all memory. *)

val check : width:int -> height:int -> (unit, string) result
(** [check ~width ~height] is [Ok ()] iff both sides are at least 1 and their
    product is at most 2^28 pixels. *)
