(** The border of what a closed outline on a plane winds around. *)

type edge = private { left : Flat.t; right : Flat.t }
(** An edge without direction: [left] is before [right] in {!Flat.compare}. *)

val of_outline : Flat.view -> Flat.t list -> edge list
(** [of_outline view corners] is the edges that part what the outline through
    [corners], closed from the last to the first, winds around a number of times
    other than zero from what it does not, by [left] and then counter-clockwise.
    Any two of them are disjoint or share an end. Corners seen in the same spot
    become one.

    Where no sides of the outline cross, edges are sides or parts between
    corners. Otherwise all is seen on the grid, and edges bend by less than its
    width to common ends. After J. D. Hobby,
    {e Practical segment intersection with finite precision output},
    Computational Geometry 13, 1999. *)
