(** A transparent coat over a matte base, as plastic is.

    The coat's surface reflects with Fresnel's exact reflectance F off the
    mirrors of {!Microfacet}, or of one smooth mirror. Let E(c) be what it sends
    back in all of the light from cosine c. The rest goes into the coat, is
    scattered by the base, evenly over directions, and leaves through the coat,
    by reciprocity with the same factor 1 − E at the cosine where it goes; light
    that the surface turns back inside meets the base again. With t the mean of
    1 − E over all light from outside, a part t / index² of the light inside
    gets out each time, and the base's BRDF is

    S(color) · (1 − E(c)) · (1 − E(c')) / (π·t), with S(k) = a·k / (1 − (1 −
    a)·k) and a = min(1, t / index²).

    It is reciprocal. A base of colour 1 gives back 1 − E(c) of the light from
    cosine c, so that all comes back; less light with any other colour. That is
    F. Saunderson's compensation (J. Saunderson,
    {e Calculation of the Color of Pigmented Plastics}, 1942) with the shape
    that makes a rough coat conserve energy too: C. Kelemen, L. Szirmay-Kalos,
    {e A Microfacet Based Coupled Specular-Matte BRDF Model}, 2001.

    For a smooth coat E is F. For a rough one it is tabulated, never too low:
    what the table adds is lost, less than 3 % of the light from any cosine. (Of
    an index below 1, near the cosine below which all is reflected, up to 40 %.)
*)

open Candor_colour

type t
(** A coat. It does not depend on the base's colour: make it once for a
    material; a rough one takes some milliseconds. *)

val make : index:float -> roughness:float -> t
(** [make ~index ~roughness] is a coat of refractive index [index], in 2^-100 …
    2^100 (below 1 it reflects all grazing light), with a surface of alpha
    [roughness] in \[0;1\], 0 for a smooth one; roughness between 0 and 2^-32
    counts as 2^-32. *)

val alpha : t -> float
(** [alpha t] is the roughness of the coat's surface, 0 or at least 2^-32. *)

val reflectance : t -> float -> float
(** [reflectance t c] is F, in \[0;1\], for light that meets a mirror at cosine
    [c]. *)

val transmittance : t -> float -> float
(** [transmittance t c] is 1 − E([c]), in \[0;1\]. *)

val base : t -> Rgb.t -> Rgb.t
(** [base t color] is S([color]) / (π·t), in 1/sr: what the transmittances of
    two directions multiply to be the BRDF of a base of this [color]. *)

val albedo : t -> Rgb.t -> Rgb.t
(** [albedo t color] is S([color]), in \[0;1\]: what part of the light that
    enters comes out again. *)
