(** Triangles as they are seen from a point: a part of the sphere of directions.

    Nothing depends on how far the corners are, and multiplying all three by a
    power of two changes no bit. *)

open Candor_space

type t
(** The directions from a point to a triangle. *)

val make : Vec.t -> Vec.t -> Vec.t -> t
(** [make a b c] is the triangle with corners at [a], [b] and [c] from the
    point, in either order round. *)

val solid_angle : t -> float
(** [solid_angle t] is its area on the unit sphere in steradians, in \[0;2π\],
    whichever way round the corners are. For the vectors as they are, it is
    within 2^-40 of itself, however small, far, thin or oblique the triangle,
    where 1 + a·b + b·c + c·a is at least .1 for the directions a, b, c of the
    corners; beyond (nearly half the sky, or corners that are nearly opposite)
    it is as good as the rounding of these directions lets it be. It is 0 where
    the three are in one plane with the point, inside the triangle as well, or
    not finite. After A. Van Oosterom, J. Strackee,
    {e The Solid Angle of a Plane Triangle}, IEEE Transactions on Biomedical
    Engineering 30(2), 1983. *)

val total : t list -> float
(** [total ts] is the sum of their solid angles, taken from the first on. *)

val density : t -> float
(** [density t] is 1 over the solid angle, which is the density of [sample t] in
    each direction inside [t]; 0 if the solid angle is 0. *)

val sample : t -> Pattern.position -> Dir.t
(** [sample t p] takes uniform [p] in \[0;1\[² to a direction inside [t], up to
    the rounding of its components, uniform by solid angle. If the solid angle
    is 0 it is some direction.

    Areas are cut off after J. Arvo,
    {e Stratified Sampling of Spherical Triangles}, SIGGRAPH 1995, in the form
    without angles of C. Peters,
    {e BRDF Importance Sampling for Polygonal Lights}, ACM Transactions on
    Graphics 40(4), 2021; arcs are measured by their chords, so that no digits
    are lost to cosines near 1 however small the triangle is. *)
