(** The light that metal and plastic reflect, smooth or rough.

    Directions point away from the surface, at a point of it; [normal] is on the
    viewer's side. Nothing is reflected unless both directions are above the
    surface. Rough ones reflect by {!Microfacet}. *)

open Candor_space
open Candor_colour

type t
(** A point of such a material. *)

val metal : reflectance:Rgb.t -> roughness:float -> t
(** [metal ~reflectance ~roughness] reflects [reflectance], in \[0;1\], of the
    light that meets a mirror straight on, and all light that grazes it, in
    between after C. Schlick,
    {e An Inexpensive BRDF Model for Physically-based Rendering}, 1994.

    Light that mirrors send to each other is lost. Of white light, a metal of
    reflectance 1 loses by alpha and cosine:

    {t
      | alpha | cosine 1 | .6     | .1     |
      |-------|----------|--------|--------|
      | .1    | 1.2 %    | 2.3 %  | 11.7 % |
      | .25   | 8.4 %    | 12.8 % | 10.8 % |
      | .5    | 31.2 %   | 31.2 % | 14.0 % |
      | .75   | 53.6 %   | 46.5 % | 18.9 % |
      | 1     | 69.3 %   | 58.8 % | 24.0 % |
    }

    [roughness] is alpha, in \[0;1\]; 0 is smooth, and roughness between 0 and
    2^-32 counts as 2^-32. *)

val plastic : Coat.t -> color:Rgb.t -> t
(** [plastic coat ~color] is a base of this colour, in \[0;1\], under [coat]. *)

val is_smooth : t -> bool
(** [is_smooth t] is [true] iff the roughness is 0. Then what follows speaks of
    the base alone, which metal has not; {!specular} is the rest. *)

val specular : t -> cos:float -> Rgb.t
(** [specular t ~cos] is the part of the light that one mirror of [t] reflects
    at the cosine [cos] to its normal: of a smooth surface, the weight of the
    perfect reflection. *)

val value : t -> normal:Dir.t -> view:Dir.t -> toward:Dir.t -> Rgb.t
(** [value t ~normal ~view ~toward] is the BRDF times the cosine of [toward], in
    1/sr. Over [toward] it integrates to 1 at most. *)

val density : t -> normal:Dir.t -> view:Dir.t -> toward:Dir.t -> float
(** [density t ~normal ~view ~toward] is how densely {!sample} samples [toward],
    per solid angle. It integrates to 1 less the chance of [None]. *)

type sample = {
  toward : Dir.t;  (** above the surface *)
  weight : Rgb.t;  (** {!value} / {!density} *)
  density : float;  (** above 0 *)
}

val sample :
  t ->
  normal:Dir.t ->
  view:Dir.t ->
  choice:float ->
  u:float ->
  v:float ->
  sample option
(** [sample t ~normal ~view ~choice ~u ~v] is a direction for [choice], [u] and
    [v] uniform in \[0;1\[: [choice] takes the coat or the base of plastic, as
    the light that each sends to [view]. [None] where nothing is reflected. *)
