(** The directions from a point to an ellipsoid, and how to choose among them,
    so that each meets it and nearly all are as likely.

    With the way [k] to the centre and the matrix [A] that makes the ellipsoid
    of the unit ball, the plane across [n] through the point touches the
    ellipsoid where n·(AAᵀ − kkᵀ)n = 0. The axes of that form are those of the
    cone in which the ellipsoid is seen: x²/α² + y²/β² ≤ z²/γ², for its
    eigenvalues α² ≥ β² and −γ². By the angle φ around the x-axis and by x, the
    area of the sphere of directions is dx·dφ (Archimedes): for each φ the cone
    has an interval of x, which is sampled uniformly, as in I. Guillén et al.,
    {e Area-Preserving Parameterizations for Spherical Ellipses}, 2017; and φ by
    a step function near its length. *)

open Candor_space
open Candor_sample

type t

val make : Affine.t -> center:Point.t -> radii:Vec.t -> both:bool -> t
(** [make m ~center ~radii ~both] is what the linear part of [m] makes of the
    ellipsoid with these half-axes along x, y and z, around [center] (which [m]
    does not move); [both] if it emits inwards too. *)

type sample = { direction : Dir.t; density : float }

val sample : t -> from:Point.t -> Pattern.position -> sample option
(** [sample t ~from p] is a direction that meets [t] up to rounding, its density
    per steradian above 0 and finite; anywhere from inside if it emits there,
    else [None]. *)

val density : t -> from:Point.t -> Dir.t -> float
(** [density t ~from d] is the density with which [sample t ~from] takes [d]: 0
    beside [t]; but for a small part near the rim close to 1 over the solid
    angle. *)

val solid_angle : t -> from:Point.t -> float
(** [solid_angle t ~from] is that in which [t] is seen, in \[0;4π\], by a
    midpoint rule that is exact to many digits unless [from] is next to [t]
    (some percent); 0 only where [sample] is [None]. *)

val area : t -> float
(** [area t] is 4π times the root mean square of what the map makes of unit
    areas of the ball: no less than the area of [t], and 2/√3 of that for the
    flattest. *)

val corners : t -> Point.t list
(** [corners t] are the images of the corners of the cube around the ball. *)
