(** What an 8- or 16-bit picture file holds: whole numbers from 0 to a largest
    value, as they stand in the file. What light they mean is for the reader to
    say. *)

type t
(** A rectangle of pixels of three samples each, rows from the top, columns from
    the left; at least one pixel each way. *)

val init :
  width:int ->
  height:int ->
  maxval:int ->
  (int -> int -> int -> (int, string) result) ->
  (t, string) result
(** [init ~width ~height ~maxval f] is the raster whose sample of column [x],
    row [y] and channel [c] (0 red, 1 green, 2 blue) is [f x y c]. [f] is called
    in the order of a file: channel by channel, pixel by pixel, row by row. The
    result is the first error of [f], or an error when a sample is outside
    \[0;[maxval]\]. Raises [Invalid_argument] unless [width] and [height] are at
    least 1 and [maxval] is in \[1;65535\]. *)

val of_picture : Picture.t -> t
(** [of_picture p] is [p] as it is displayed: [maxval] is 255 and every sample
    is {!Candor_colour.Display.level} of the radiance. *)

val width : t -> int
val height : t -> int

val maxval : t -> int
(** [maxval r] is the value of full brightness, in \[1;65535\]: 255 for 8-bit
    files. *)

val sample : t -> int -> int -> int -> int
(** [sample r x y c] is the number in column [x], row [y], channel [c], in
    \[0;[maxval r]\]. Raises [Invalid_argument] outside the raster. *)

val equal : t -> t -> bool
(** [equal a b] is [true] iff size, largest value and all samples agree. *)
