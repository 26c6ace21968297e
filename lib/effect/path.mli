(** What a light path carries from one surface to the next: one immutable value.
*)

open Candor_colour
open Candor_sample
open Candor_scene
open Candor_optics

(** How the direction of the ray under way was chosen. *)
type arrival =
  | Sharp  (** by the camera, a mirror or glass: there was no other choice *)
  | Spread of { density : float; from : Area_lights.vantage }
      (** at [from], at random with this density per solid angle: what lights
          have sent there already counts less if it is met again *)

type journey = {
  sample : int;  (** which sample of its pixel the path is *)
  time : float;
  arrival : arrival;
  inside : Material.t list;
      (** the glass and the translucent bodies around, entered last first *)
  wavelength : float option;
      (** in nanometres, once the path has met a medium that needs one *)
}
(** What most paths keep from their first ray to their last. *)

type t = {
  throughput : Rgb.t;  (** the share of what is found that reaches the camera *)
  depth : int;  (** reflections, refractions and bounces so far *)
  key : Key.t;  (** what the random numbers of the next surface come from *)
  journey : journey;
}

val start : t
(** [start] is the path of the camera ray of a picture in which nothing is left
    to chance: throughput 1, depth 0, time 0, in empty space. *)

val camera : Key.t -> sample:int -> time:float -> inside:Material.t list -> t
(** [camera k ~sample ~time ~inside] is the path of a camera ray of the pixel
    that [k] names. *)

(** {1 Random numbers}

    They depend on the pixel, the sample, the way the path has come and the
    purpose, and on nothing else. *)

val one : t -> Key.purpose -> float
(** [one p purpose] is uniform in \[0;1\[. *)

val pair : t -> Key.purpose -> Pattern.position
(** [pair p purpose] is uniform in the unit square. *)

val onward : t -> Key.purpose -> Rgb.t -> journey -> t
(** [onward p branch throughput journey] is [p] one step further, with random
    numbers of its own for each [branch]. *)
