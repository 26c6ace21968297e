(** Every effect that Candor knows. To add one is to add a file and a
    constructor; the compiler then names every place that must know it. *)

open Candor_scene

type t =
  | Emission
  | Ambient
  | Direct
  | Shadows
  | Soft_shadows
  | Sky_light
  | Mirror
  | Refraction
  | Dispersion
  | Absorption
  | Subsurface
  | Gloss
  | Indirect
  | Fog
  | Depth_of_field
  | Motion_blur
  | Textures
  | Smooth_normals
  | Anti_aliasing
[@@deriving show, eq, ord]

val all : t list
(** [all] is every effect once, in the order that terms are summed. *)

val name : t -> string
(** [name e] is what commands call [e]. *)

val meaning : t -> string
(** [meaning e] is one line for people. *)

val calls : t -> Scene.t -> Reason.t list
(** [calls e s] is what in [s] asks for [e]; [[]] if nothing does. *)

val rays : t -> Tally.counter option
(** [rays e] is the counter of the rays that only [e] traces, if it does. *)
