(** Quadrics: the zero set of a polynomial of degree two, cut to size. *)

open Candor_space

type t
(** The points where F = 0, within the closed clip box; outside is F > 0. Named
    forms keep their double coefficients about their own first point. *)

val make : ?clip:Bounds.t -> ?caps:bool -> Quadric_shape.t -> (t, string) result
(** [make shape] is that quadric. Cylinders, cones and paraboloids are cut by
    the planes through their ends across the axis; [caps] (default [false]) adds
    the disks there. [Error why] for an asymmetric matrix, a constant F, radii
    that are not positive, an axis of no length, [caps] on another shape, an
    empty [clip], or numbers beyond 2^400. *)

val shape : t -> Quadric_shape.t
(** [shape q] is what [q] was made from. *)

val clip : t -> Bounds.t option
(** [clip q] is the clip box as given. *)

val caps : t -> bool
(** [caps q] is [true] iff the ends are closed by disks. *)

val equal : t -> t -> bool
(** [equal a b] is [true] iff both were made from the same numbers. *)

val pp : Format.formatter -> t -> unit
(** [pp] prints what [q] was made from. *)

val show : t -> string
val compare : t -> t -> int

val body : t -> Piece.t
(** [body q] is the polynomial with its cuts. *)

val bounds : t -> Bounds.t
(** [bounds q] is a box that holds [q]; not finite where [q] is unbounded. *)

val meet : t -> Object_ray.t -> Contact.t -> Cursor.t -> Contact.t
(** [meet q ray left cursor] is the first contact of [ray] with [q] within
    [cursor], which moves there. Part 0 is the quadric itself, parts 1 and 2 the
    caps at its second and first end. A ray that [left] part 0 has its root at 0
    taken out of the equation; one that left a cap never meets that cap again. A
    line that lies in the quadric does not meet it. *)

val locate : t -> Object_ray.t -> float -> Contact.t -> Local.t
(** [locate q ray t contact] is the point of [q] at [t], moved onto it by Newton
    steps along the gradient; found from the point of the ray nearest to the
    centre where the doubles near [t] are too far apart. Where the gradient
    vanishes (the apex of a cone) the normal is the direction the ray came from.
*)
