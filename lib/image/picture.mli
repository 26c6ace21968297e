(** A finished picture: linear radiance for every pixel. *)

open Candor_colour

type t
(** A rectangle of pixels, rows from the top, columns from the left; at least
    one pixel each way. *)

val init : width:int -> height:int -> (int -> int -> Rgb.t) -> t
(** [init ~width ~height f] is the picture whose pixel in column [x] and row [y]
    is [f x y]. [f] is called row by row. Raises [Invalid_argument] unless
    [width] and [height] are at least 1. *)

val of_rows : width:int -> floatarray array -> t
(** [of_rows ~width rows] is the picture with these rows, each [3 * width]
    numbers, red, green and blue of every pixel in turn. The rows are not
    copied; the caller gives them up. Raises [Invalid_argument] when there is no
    row, [width < 1], or a row has another length. *)

val width : t -> int
val height : t -> int

val pixel : t -> int -> int -> Rgb.t
(** [pixel p x y] is the radiance in column [x], row [y], both from 0. Raises
    [Invalid_argument] outside the picture. *)

val equal : t -> t -> bool
(** [equal a b] is [true] iff both have the same size and the same bits in every
    pixel (so [nan] equals itself, and [0.] differs from [-0.]). *)
