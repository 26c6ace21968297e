(** What light falls on: a point of a surface, or of a medium. *)

open Candor_space
open Candor_colour
open Candor_optics

type t = {
  vantage : Area_lights.vantage;  (** where it is, and when *)
  spawn : Vec.t -> Ray.t;  (** the ray that leaves along a direction *)
  respond : Dir.t -> Rgb.t;
      (** what is sent to the viewer per irradiance from there, in 1/sr *)
  density : Dir.t -> float;
      (** how densely paths go on there by themselves, per solid angle; 0 if
          they do not *)
}

val vantage : Term.vertex -> Area_lights.vantage
(** [vantage v] is the place of [v]. *)

val in_space : Path.t -> Point.t -> Area_lights.vantage
(** [in_space path p] is [p], on no surface, at the time of [path]. *)

val of_vertex : Scattering.t -> goes_on:bool -> Term.vertex -> t
(** [of_vertex s ~goes_on v] is the surface met at [v], where paths go on as [s]
    samples directions iff [goes_on]. *)

val lit :
  Scattering.t ->
  goes_on:(Term.vertex -> bool) ->
  (Tally.t -> Path.t -> t -> Rgb.t) ->
  Term.t
(** [lit s ~goes_on estimate] is the term of light that [estimate] finds to fall
    on surfaces, where [s] shows any; [goes_on] as in {!of_vertex}. *)

val in_medium :
  Medium.t -> goes_on:bool -> Path.t -> Point.t -> along:Dir.t -> t
(** [in_medium m ~goes_on path p ~along] is a point of [m], where light that
    comes to the viewer along −[along] is scattered. *)

val power : float -> float -> float
(** [power p q] is how much a direction of density [p] counts that could have
    come with density [q] in another way, after E. Veach, L. J. Guibas,
    {e Optimally Combining Sampling Techniques for Monte Carlo Rendering}, 1995:
    p² / (p² + q²). *)
