(** Area lights and their soft shadows: surfaces that emit light others. *)

open Candor_space
open Candor_colour
open Candor_scene
open Candor_optics

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the materials in use that emit, where something shows light
    that falls on it. *)

val veiled :
  Direct.veil option -> Path.t -> Point.t -> Point.t -> Rgb.t -> Rgb.t
(** [veiled veil path point at light] is what arrives at [point] of [light] from
    [at]. *)

type estimate = Tally.t -> Path.t -> Receiver.t -> Rgb.t
(** What a receiver sends to the viewer of the light of one area light, chosen
    at random, over the chance of that. *)

val estimate : ?veil:Direct.veil -> Area_lights.t -> Tracer.t -> estimate
(** [estimate lights tracer] traces one ray towards one light. Where paths go on
    from the receiver by themselves and may meet the same light, the two ways
    share it as {!Receiver.power} says. *)

val weigh : Area_lights.t -> Emission.weigh
(** [weigh lights path hit] is the share of a path that meets a light by itself.
*)

val term : Scattering.t -> goes_on:(Term.vertex -> bool) -> estimate -> Term.t
(** [term scattering ~goes_on estimate] adds the light of area lights to
    surfaces; [goes_on] tells where paths go on. *)
