(** Pixels without samples show what one nearby does that has some. *)

type t

val of_map : Sample_map.t -> t
(** [of_map m] is of the pixels of [m]'s window. *)

val pixel : t -> int -> int -> int * int
(** [pixel s x y] is the column and the row of the pixel whose samples pixel (x,
    y) shows: its own if it has some, else one that has, the fewest steps away,
    straight or diagonal; of several, the first row by row. Both are of the full
    picture, and (x, y) is in the map's window. *)

val window : t -> Window.t -> Window.t
(** [window s w] is the least window that has the pixels of [w] and all that
    they show. *)
