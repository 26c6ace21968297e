(** How many samples each pixel of a picture has: what repeats an adaptive
    render to the bit. *)

type t

val v : width:int -> height:int -> spp:int -> Window.t -> int array array -> t
(** [v ~width ~height ~spp window counts] is of a picture of that size, whose
    scene asks for [spp] samples per pixel at most, and whose rows in [window]
    have [counts], none below 0 and one at least above. *)

val window : t -> Window.t
val width : t -> int
val height : t -> int

val spp : t -> int
(** [spp m] is what the scene asked for: places in pixels depend on whether that
    is 1. *)

val samples : t -> int -> int -> int
(** [samples m x y] is the number of samples of the pixel (x, y) of the full
    picture, which must be in the window. *)

val least : t -> int
(** [least m] is how many samples the pixel has that has fewest: 0 where one has
    none, and shows what its {!Stand_in} does. *)

val empty : t -> int
(** [empty m] is how many pixels have none. *)

val most : t -> int

val total : t -> float
(** [total m] is the number of all samples. *)

val crop : t -> Window.t -> t
(** [crop m w] is the part of [m] in [w], which [m]'s window contains; all of it
    may be without samples. *)

val contains : t -> Window.t -> bool
(** [contains m w] is [true] iff all of [w] is in [m]'s window. *)

(** {1 As text} *)

val to_string : t -> string
(** [to_string m] is two lines, [candor-map 1 width W height H spp N] and
    [window X0 Y0 X1 Y1], then a line for each row: the numbers of samples, each
    written once for a run of equal pixels, as [NxK] for K of them. *)

val of_string : string -> (t, string) result
(** [of_string s] is the map that {!to_string} wrote. The error says what is
    wrong, and in which line. *)
