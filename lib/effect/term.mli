(** Terms of the light equation: what each adds to the radiance that leaves a
    point towards where the path came from. *)

open Candor_space
open Candor_colour
open Candor_surface
open Candor_optics

type vertex = {
  hit : Skin.t Hit.t;  (** where the path met a surface *)
  view : Vec.t;  (** from there back along the ray, of any length *)
  lobes : Lobes.t;  (** what the surface does with light there *)
  path : Path.t;
}

type radiance = Tally.t -> kind:string -> Path.t -> Ray.t -> Rgb.t
(** What a ray brings: the recursion that a term is handed. [kind] names the ray
    for watchers. *)

type t = radiance -> Tally.t -> vertex -> Rgb.t
(** A term: radiance in W/(m² sr), black where the effect is absent. *)
