(** Sixty-one parts of a picture's pixels that judge each other.

    Each part is a square lattice, turned so that every row, column and diagonal
    meets all parts in turn. How many samples a pixel gets beside others is what
    its {!advisers} say, its nearest neighbours; when it has enough, the
    {!judges} of its part: all parts but itself and those that it advises. So
    none of a part's samples has a say in how many they are. *)

val count : int
(** [count] is 61, which is 5² + 6²: pixels of a part are √61 apart. *)

val of_pixel : int -> int -> int
(** [of_pixel x y] is the part of the pixel in column [x] and row [y], from 0 to
    60. *)

val all : int list
(** [all] is 0 to 60. *)

val advisers : (int * int) list * (int * int) list
(** [advisers] is where the neighbours are that advise a pixel, in columns and
    rows from it: two groups alike, six around it each. It advises them in turn.
*)

val judges : int -> int list
(** [judges i] is the 48 parts that judge part [i]. *)

val turn : int -> int
(** [turn i] is the place of part [i], from 0 to 60, in an order in which the
    first few lie evenly in the picture: the square of the distance to the
    nearest of them is at most a quarter of the area that each has, on average.
*)

val is_in : Window.t -> int -> bool
(** [is_in window i] is whether the window has pixels of part [i]. *)
