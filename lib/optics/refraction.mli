(** What a smooth boundary between two transparent media does to light: Snell's
    and Fresnel's laws, after M. Born, E. Wolf, {e Principles of Optics}, 7th
    edition, 1999, section 1.5.

    Cosines are of the angle to the normal on the side that the light comes
    from. They are taken as 0 below 0 and as 1 above 1: products of unit vectors
    leave that range by rounding. *)

open Candor_space

type boundary = { from : float; into : float }
(** The refractive indices of the medium that the light comes from and of the
    one behind the boundary, in 2^-100 … 2^100. Only their ratio matters, but
    the ratio of two doubles need not be one: what follows speaks of the exact
    one. *)

val reverse : boundary -> boundary
(** [reverse b] is [b] seen from the other side. *)

val discriminant : boundary -> float -> float
(** [discriminant b c] is into² − from²·(1 − c²), the square of [into] times the
    cosine of the angle of refraction, for light that comes in at cosine [c]. It
    is within 2 units in the last place and its sign is exact: light is totally
    reflected iff it is negative. (It is zero only for equal indices and [c] =
    0. Between equal indices c² must stay in the range of doubles.) The
    difference of products is W. Kahan's, as in
    {!Candor_number.Error_free.difference_of_products}, to which the rounding
    errors of its factors are added. *)

val reflectance : boundary -> float -> float
(** [reflectance b c] is the part of unpolarised light of cosine [c] that is
    reflected, in \[0;1\]: 1 under total reflection, 0 between equal indices;
    elsewhere right within 2^-47 of itself. *)

type t =
  | Total_reflection
  | Transmitted of { direction : Dir.t; reflectance : float }
      (** where the transmitted light goes, and the part that is reflected *)

val at : boundary -> normal:Dir.t -> Dir.t -> t
(** [at b ~normal d] is what becomes of light that travels along [d] against
    [normal], decided exactly for the cosine −normal·d as rounded. The direction
    obeys Snell's law, from·sin θ = into·sin θ', and lies in the plane of [d]
    and [normal] within 2^-49 · max(1, (from/into)²). *)
