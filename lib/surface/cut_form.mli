(** Where rays meet a {!Piece} of a quadric, disks included: the kernel of
    {!Quadric}. *)

open Candor_space

type t = Piece.t

val make : Form.t -> cuts:Half_space.t array -> disks:int array -> t
(** [make] is {!Piece.make}. *)

val meet : t -> Object_ray.t -> Contact.t -> Cursor.t -> Contact.t
(** [meet q ray left cursor] is the first contact of [ray] with [q] within
    [cursor], which moves there. Part 0 is the zero set, part [i + 1] the disk
    of cut [i]; for the rest see {!Quadric.meet}. *)
