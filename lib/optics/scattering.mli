(** How a surface spreads the light that falls on it: value, sample and density
    of all of its lobes but the mirror's.

    [normal] is the shading normal on the viewer's side; [view] and [toward]
    point away from the surface. *)

open Candor_space
open Candor_colour
open Candor_sample

type t = {
  value : Lobes.t -> normal:Dir.t -> view:Dir.t -> toward:Dir.t -> Rgb.t;
      (** radiance towards [view] per irradiance on a surface that faces
          [toward], in 1/sr *)
  density : Lobes.t -> normal:Dir.t -> view:Dir.t -> toward:Dir.t -> float;
      (** of what [sample] takes, per solid angle *)
  sample :
    Lobes.t ->
    normal:Dir.t ->
    view:Dir.t ->
    choice:float ->
    Pattern.position ->
    Gloss.sample option;
      (** a direction for [choice] in \[0;1\[ and a place in the unit square,
          with value/density, Blinn's highlight apart *)
  is_black : Lobes.t -> bool;  (** whether [value] is black everywhere *)
}

val matte : t
(** [matte] knows matte lobes and Blinn's highlights only. *)

val glossy : t
(** [glossy] knows gloss, too. *)
