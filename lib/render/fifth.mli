(** Five parts of a picture's pixels that judge each other.

    Each part is spread over the whole picture as by knight's moves: every row,
    column and diagonal meets all five in turn. How a fifth is sampled, and when
    it stops, is decided by the two that follow it, its {!judges}, which do not
    ask it back: so none of its own samples has a say in how many they are. *)

val count : int
(** [count] is 5. *)

val of_pixel : int -> int -> int
(** [of_pixel x y] is the fifth of the pixel in column [x] and row [y], from 0
    to 4. *)

val all : int list
(** [all] is 0 to 4. *)

val judges : int -> int * int
(** [judges i] is the two after fifth [i]. *)
