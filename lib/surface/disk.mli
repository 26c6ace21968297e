(** The disks that close a {!Piece} where it is cut. *)

open Candor_space

val meet : Piece.t -> Object_ray.t -> int -> Contact.t -> Cursor.t -> Contact.t
(** [meet q ray i left cursor] is the contact of [ray] with the disk on the
    plane of cut [i] within [cursor], which moves there: the points of the other
    cuts where F is at most 0, decided exactly. A ray that [left] the disk never
    meets it again. *)
