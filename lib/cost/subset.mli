(** A few pixels that stand for a picture: one of each block of it, so that they
    are a small picture themselves. *)

type t

val make : width:int -> height:int -> seed:int -> pixels:int -> t
(** [make ~width ~height ~seed ~pixels] parts a picture of [width] by [height]
    into about [pixels] blocks (at least one, and never more than there are
    pixels) that are as square and as equal as they can be, and takes one pixel
    of each, at a place that [seed] chooses, evenly. *)

val width : t -> int
(** [width s] is how many blocks stand beside each other. *)

val height : t -> int
(** [height s] is how many stand above each other. *)

val count : t -> int
(** [count s] is [width s * height s]. *)

val pixel : t -> int -> int * int
(** [pixel s i] is the column and the row of the [i]-th pixel in the whole
    picture, 0 ≤ i < [count s], row by row from the top left. *)

val share : t -> float
(** [share s] is the part of all pixels that [s] has, in \]0;1\]. *)
