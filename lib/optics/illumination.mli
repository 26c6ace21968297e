(** What a light without extent sends to a point. *)

open Candor_space
open Candor_colour
open Candor_scene

type t = {
  toward : Vec.t;  (** from the point towards the light, of any length *)
  irradiance : Rgb.t;
      (** on a surface that faces the light, nothing in between, in W/m² *)
}

type source =
  | At of Point.t  (** the light is here *)
  | Along of Vec.t  (** the light is infinitely far in this direction *)

val source : Light.t -> source
(** [source l] is where shadow rays to [l] go. *)

val compile : Light.t -> Point.t -> t
(** [compile l] is the function from a point to what [l] sends there; work that
    does not depend on the point is done once. *)
