(** Places on a plane, as seen along an axis of space: in two coordinates, on
    which every decision is exact. *)

open Candor_space

type t = private { u : float; v : float; place : Point.t }
(** [place], seen at [(u, v)] in the square from -1 to 1. *)

type view
(** An axis, and powers of two that bring what is seen along it near 1. *)

val view : axis:int -> Point.t list -> view
(** [view ~axis points] is for seeing [points] along [axis], one of [0], [1],
    [2]. The axis points to the viewer: what runs counter-clockwise about it
    does so in [u] and [v]. *)

val see : view -> Point.t -> t
(** [see view p] is [p] seen exactly, but that a [u] or [v] below 2^-450 is 0.
*)

val compare : t -> t -> int
(** [compare a b] orders by [u], then by [v]: what is seen in one spot is equal.
*)

val equal : t -> t -> bool
(** [equal a b] is [compare a b = 0]. *)

val turn : t -> t -> t -> int
(** [turn a b c] is 1 where the path from [a] by [b] to [c] turns left, -1 where
    it turns right and 0 where the three are on one line. *)

val facing : t list -> int
(** [facing outline] is 1 where the area that the closed outline winds around is
    positive (counter-clockwise) in total and -1 where it is negative. Where it
    is zero, as for a bow-tie with equal halves, what counts is the first turn
    seen from the first corner; 0 if all corners are on one line with it. *)

(** {1 The grid}

    Crossings can only be rounded. They are on the grid of multiples of 2^-53 in
    [u] and [v], and each point of the grid stands for the square around it,
    open above and on the right. *)

val to_grid : t -> t
(** [to_grid a] is [a], with its place, but seen at the nearest point of the
    grid. *)

val crossing : view -> t * t -> t * t -> t
(** [crossing view (a, b) (c, d)] is a point of the grid within its width of
    where the segment from [a] to [b] crosses the one from [c] to [d]. The ends
    of each must be on the grid and on different sides of the other. *)

val enters : t * t -> t -> bool
(** [enters (a, b) p] is [true] iff the segment from [a] to [b] meets the square
    of [p]. All must be on the grid, and [p.u] from [a.u] to [b.u]. *)
