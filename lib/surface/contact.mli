(** Which part of a surface a ray meets or leaves, and on which side: packed
    into an immediate integer, so that kernels pass it without allocating. *)

open Candor_space

type t = private int

val none : t
(** [none] is no contact: a miss, or a ray that does not start on the surface.
*)

val v : part:int -> Side.t -> t
(** [v ~part side] is contact with part [part ≥ 0] on [side]. Parts are numbered
    by each surface: the faces of a box, the caps of a quadric, else 0. *)

val is_none : t -> bool

val part : t -> int
(** [part c] is the part of a contact other than [none]. *)

val side : t -> Side.t
(** [side c] is the side of a contact other than [none]. *)
