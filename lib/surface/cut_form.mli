(** Where rays meet the zero set of a polynomial of degree two, cut to size: the
    kernel of {!Quadric}. *)

open Candor_space

type t = private {
  form : Form.t;
  linear : bool;  (** whether [form] is *)
  cuts : Half_space.t array;
  disks : int array;  (** the cuts, by index, that a disk closes *)
}
(** The points of all [cuts] where [form] is 0; and on the plane of each cut in
    [disks] those of the other cuts where [form] is at most 0. *)

val make : Form.t -> cuts:Half_space.t array -> disks:int array -> t
(** [make form ~cuts ~disks] is that set. *)

val meet : t -> Object_ray.t -> Contact.t -> Cursor.t -> Contact.t
(** [meet q ray left cursor] is the first contact of [ray] with [q] within
    [cursor], which moves there. Part 0 is the zero set, part [i + 1] the disk
    of cut [i]; for the rest see {!Quadric.meet}. *)
