(** Dispersion: glass bends blue light more than red. *)

open Candor_colour
open Candor_scene

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the materials in use that have an Abbe number. *)

val index_at : index:float -> abbe:float -> float -> float
(** [index_at ~index ~abbe l] is the refractive index for light of [l]
    nanometres of glass that has [index] at 587.6 (the yellow line of helium)
    and this Abbe number (index − 1) / (n_F − n_C), with n_F at 486.1 and n_C at
    656.3: A + B/l², after A. L. Cauchy,
    {e Mémoire sur la dispersion de la lumière}, 1836. *)

val wavelength : float -> float
(** [wavelength u] is uniform between 380 and 720 nanometres for [u] in \[0;1\[.
*)

val colour : float -> Rgb.t
(** [colour l] is the weight of light of [l] nanometres in the three primaries;
    its mean over {!wavelength} is white. It is the CIE 1931 observer's by C.
    Wyman, P.-P. Sloan, P. Shirley,
    {e Simple Analytic Approximations to the CIE XYZ Color Matching Functions},
    JCGT 2(2), 2013, in linear sRGB, without its negative parts. *)

val term : (Refraction.index -> Term.t) -> Term.t
(** [term refraction] is [refraction] with the index of the path's wavelength. A
    path has none until it meets a boundary of glass that disperses light, or
    one inside such glass; there one is chosen at random. *)
