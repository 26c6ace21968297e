(** Flat polygons, as the triangles that they mean. *)

open Candor_space

type t = private { corners : Point.t list; triangles : Triangle.t list }
[@@deriving show, eq, ord]
(** What a closed line of corners winds around a number of times other than
    zero.

    The triangles cover it without gap or overlap. Where no two sides cross they
    have no corners but the polygon's, and none lies within a side of another
    triangle; sides may touch, run along each other and there and back. The
    triangles of a polygon that does not even touch itself are two fewer than
    its corners.

    Where sides cross, triangles also meet in the crossings, rounded to a grid
    of 2^-53 of the largest coordinate on each axis. Everything is then seen on
    this grid, so that triangles may overlap, or the border be off, by less than
    its width.

    All triangles face the way that the outline runs counter-clockwise: around
    more area than it runs clockwise around or, if these are equal, in its first
    turn as seen from its first corner. *)

val make : Point.t list -> (t, string) result
(** [make corners] is the polygon with these corners in order, closed from the
    last to the first. [Error why] with fewer than three different corners, no
    area, a corner that is farther than 2^-40 of the polygon's size from its
    plane, or one beyond 2^400.

    The size is the greatest extent along an axis. The plane goes through the
    mean of the corners, at right angles to the area that the outline sweeps
    around it. This one test is in doubles; the others are exact, on the corners
    as seen along the axis that is nearest to the plane's normal.

    The cost is at most of the order n², n counting corners and crossings. *)
