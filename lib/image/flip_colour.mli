(** Colours as {!Flip} sees them: the spaces that it goes through, on the way
    from the light of a display to how different two colours look.

    The light is linear RGB of sRGB's primaries, 1 the display's white (D65). *)

open Candor_colour

val linear_of_srgb : float -> float
(** [linear_of_srgb v] is the light of an sRGB display driven by the value [v],
    both in \[0;1\] (IEC 61966-2-1, 1999). *)

type opponent = {
  y : float;  (** achromatic: −16 for black, 100 for white. *)
  cx : float;  (** red against green; 0 for greys. *)
  cz : float;  (** blue against yellow; 0 for greys. *)
}
(** YCxCz, the linear form of CIELAB, in which vision's blur is applied: after
    T. Kolpatzik, C. Bouman, {e Optimized Error Diffusion for Image Display},
    1992. *)

val opponent : Rgb.t -> opponent
(** [opponent light] is [light] in YCxCz, linearly but for the constant. *)

val light : opponent -> Rgb.t
(** [light o] is the light whose {!val-opponent} is [o], to six digits, each
    component clamped to \[0;1\]. *)

val brightness : float -> float
(** [brightness y] is an achromatic value as a part of white: 0 for black, 1 for
    white. *)

type seen = { l : float; a : float; b : float }
(** CIELAB, its colour paler the darker it is (R. W. G. Hunt,
    {e Light and Dark Adaptation and the Perception of Color}, 1952): [a] and
    [b] are CIELAB's times [l] / 100. *)

val seen : Rgb.t -> seen
(** [seen light] is how [light] looks; [l] is in \[0;100\] for light in \[0;1\].
*)

val distance : seen -> seen -> float
(** [distance s t] is HyAB, what lies between two colours that differ much: |Δl|
    \+ √(Δa² + Δb²). After S. Abasi, M. Amani Tehran, M. D. Fairchild,
    {e Distance Metrics for Very Large Color Differences}, 2020. *)
