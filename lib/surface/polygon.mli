(** Flat polygons, as the triangles that they mean. *)

open Candor_space

type t = private { corners : Point.t list; triangles : Triangle.t list }
[@@deriving show, eq, ord]
(** What a closed line of corners winds around a number of times other than
    zero. The triangles cover it without gap or overlap, and face the way that
    the outline runs counter-clockwise. *)

val make : Point.t list -> (t, string) result
(** [make corners] is the polygon with these corners in order, closed from the
    last to the first. [Error why] with fewer than three different corners, no
    area, or corners that are farther than 2^-40 of the polygon's size from one
    plane. *)
