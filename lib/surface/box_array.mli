(** Many bounding boxes in one flat array, for building hierarchies without
    allocating a box at a time. Box [i] is x0 x1 y0 y1 z0 z1 from index 6i. *)

open Candor_space

type t = floatarray

val create : int -> t
(** [create n] is room for [n] boxes that mean nothing yet. *)

val set : t -> int -> Bounds.t -> unit
val get : t -> int -> Bounds.t

val clear : t -> int -> unit
(** [clear b i] makes box [i] empty. *)

val grow : t -> int -> t -> int -> unit
(** [grow b i c j] makes box [i] of [b] hold box [j] of [c] too. *)

val grow_by_center : t -> int -> t -> int -> unit
(** [grow_by_center b i c j] makes box [i] of [b] hold the centre of box [j]. *)

val copy : t -> int -> t -> int -> unit
(** [copy b i c j] makes box [i] of [b] equal to box [j] of [c]. *)

val center : t -> int -> int -> float
(** [center b i axis] is the middle of box [i] on [axis]. *)

val low : t -> int -> int -> float
(** [low b i axis] is the low end of box [i] on [axis]. *)

val extent : t -> int -> int -> float
(** [extent b i axis] is the length of box [i] along [axis]. *)

val widest : t -> int -> int
(** [widest b i] is the axis along which box [i] is longest, the first of those
    that tie. *)

val half_area : t -> int -> unit:float -> float
(** [half_area b i ~unit] is half the surface of box [i] in units of unit², 0
    after {!clear}. *)
