(** Reflection by a rough surface: one of many tiny mirrors whose normals spread
    about its own.

    The distribution is GGX, after B. Walter, S. Marschner, H. Li, K. Torrance,
    {e Microfacet Models for Refraction through Rough Surfaces}, 2007. Masking
    is Smith's, correlated by height, after E. Heitz,
    {e Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs},
    JCGT 3(2), 2014.

    [alpha] is the slope that about half of the mirrors exceed, in \[2^-32;1\].
    Cosines are of the angle to the surface's normal. Directions point away from
    the surface. Light goes back only from mirrors that it meets first: what
    meets a second mirror is lost. *)

open Candor_space

val distribution : alpha:float -> normal:Dir.t -> Vec.t -> float
(** [distribution ~alpha ~normal h] is the area of the mirrors that face along
    [h], a vector of any length, per solid angle and per area of the surface; 0
    unless [h] is above the surface. The integral of it times the cosine of [h]
    is 1. The sine comes from a cross product, so the peak is as sharp as the
    rounding of [h] and [normal] allows. *)

val lambda : alpha:float -> float -> float
(** [lambda ~alpha c] is Smith's Λ at cosine [c]: the area of mirrors facing
    away, as seen from there, over the area seen of the surface. It is infinite
    for [c ≤ 0]. *)

val masking : alpha:float -> float -> float
(** [masking ~alpha c] is G₁ = 1 / (1 + Λ(c)), the part of the mirrors facing
    the direction at cosine [c] that can be seen from there; 0 for [c ≤ 0]. *)

val shared_masking : alpha:float -> float -> float -> float
(** [shared_masking ~alpha c c'] is G₂ = 1 / (1 + Λ(c) + Λ(c')), the part that
    can be seen from both directions; 0 unless both are above the surface. *)

val reflection :
  alpha:float -> normal:Dir.t -> view:Dir.t -> toward:Dir.t -> float
(** [reflection ~alpha ~normal ~view ~toward] is the BRDF of perfect mirrors,
    D·G₂ / (4·c·c'), in 1/sr; 0 unless both directions are above the surface. *)

val visible : alpha:float -> normal:Dir.t -> view:Dir.t -> half:Dir.t -> float
(** [visible ~alpha ~normal ~view ~half] is the density, per solid angle, of
    [half] among the normals of the mirrors that are seen from [view]. *)

val density : alpha:float -> normal:Dir.t -> view:Dir.t -> toward:Dir.t -> float
(** [density ~alpha ~normal ~view ~toward] is the density, per solid angle, of
    the directions that such mirrors reflect [view] into; 0 unless both
    directions are above the surface. *)

val seen : alpha:float -> Vec.t -> u:float -> v:float -> Vec.t
(** [seen ~alpha view ~u ~v] is a mirror's normal, of length 1, distributed as
    {!visible} for uniform [u] and [v] in \[0;1\[. [view] has length 1; for both
    the surface's normal is the z axis. After J. Dupuy, A. Benyoub,
    {e Sampling Visible GGX Normals with Spherical Caps}, 2023. *)

val seen_again : alpha:float -> float -> float -> float
(** [seen_again ~alpha c c'] is G₂ / G₁(c): the part of what is reflected from
    cosine [c] towards cosine [c'] that no other mirror takes; 0 for [c' ≤ 0],
    else in \]0;1\]. *)
