(** Triangles that fill what a border encloses. *)

val triangles : Border.edge list -> (Flat.t * Flat.t * Flat.t) list
(** [triangles border] is what lies within [border], as {!Border.of_outline}
    makes it, cut into triangles. Their corners are ends of edges and run
    counter-clockwise; none overlap, none has a corner on another's side, and
    none is without area.

    After S. Hertel, K. Mehlhorn, {e Fast triangulation of simple polygons}, FCT
    1983: a sweep from left to right. *)
