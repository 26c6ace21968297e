(** The five intersections as lectures write them, in plain doubles, to measure
    what stability costs and what breaks without it. Hits count only beyond an
    epsilon, so that a surface does not meet itself.

    The sphere and the epsilon are those of K. Beason, {e smallpt}, 2008, for
    directions of any length; boxes by slabs (T. L. Kay, J. T. Kajiya,
    {e Ray Tracing Complex Scenes}, 1986); triangles after T. Möller, B.
    Trumbore, {e Fast, Minimum Storage Ray/Triangle Intersection}, 1997;
    quadrics by the school formula. *)

open Candor_space

val epsilon : float
(** [epsilon] is 10^-4 scene units, at every scale. *)

val sphere : Sphere.t -> Point.t -> Vec.t -> Cursor.t -> Contact.t
(** [sphere s o d cursor] is the first contact of the ray from [o] along [d]
    with [s] within [cursor], which moves there. The others are alike. *)

val box : Box.t -> Point.t -> Vec.t -> Cursor.t -> Contact.t
val triangle : Triangle.t -> Point.t -> Vec.t -> Cursor.t -> Contact.t
val quadric : Quadric.t -> Point.t -> Vec.t -> Cursor.t -> Contact.t

val group : Transform.t -> Object_ray.t -> Object_ray.t
(** [group m ray] is [ray] in the space inside [m]: its numbers multiplied by
    the inverse matrix, and rounded. *)

val moved : Vec.t -> Object_ray.t -> Object_ray.t
(** [moved d ray] is [ray] as seen by what has moved by [d], rounded. *)

(** {1 What is hit}

    The point at [t], nowhere moved onto the surface; its error is not known and
    given as 0. *)

val locate_sphere : Sphere.t -> Object_ray.t -> float -> Contact.t -> Local.t
val locate_box : Box.t -> Object_ray.t -> float -> Contact.t -> Local.t
val locate_triangle : Triangle.t -> Object_ray.t -> float -> Local.t
val locate_quadric : Quadric.t -> Object_ray.t -> float -> Contact.t -> Local.t
