(** Environments sampled where they are bright.

    The centres of texels, and the poles beyond the first and the last row, cut
    the sphere into cells. In each the density is constant per solid angle, in
    proportion to the mean luminance of the four texels at its corners: it is
    positive wherever the radiance is, so estimates do not lean. *)

open Candor_space
open Candor_colour
open Candor_scene

type t
(** A distribution over directions. *)

type sample = {
  direction : Dir.t;
  radiance : Rgb.t;  (** from there, as {!Texels.radiance} says *)
  density : float;  (** per steradian, positive; that of {!density} *)
}

val make : Texels.t -> t option
(** [make texels] is for the environment that the equirectangular [texels] are;
    [None] if it is black. Takes time and memory linear in the size. *)

val sample : t -> u:float -> v:float -> sample option
(** [sample t ~u ~v] takes uniform [u], [v] in \[0;1\[ to a direction. [None],
    for no light, only where rounding leads across the border to a black cell.
*)

val density : t -> Dir.t -> float
(** [density t d] is that of [sample t] at [d], per steradian; its integral over
    the sphere is 1. *)
