(** Fog: a medium in what would be empty space takes light away and scatters it.
*)

open Candor_scene

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] is [(fog ...)], unless it is perfectly clear. *)

type scatter = Tally.t -> Path.t -> Receiver.t -> Candor_colour.Rgb.t
(** The light of lights that a point sends to the viewer. *)

type order =
  | Once  (** light is scattered towards the viewer once, from lights *)
  | Again of Limit.t  (** light that was scattered may be scattered again *)

val clear : Scene.fog
(** [clear] is fog that does nothing. *)

val segment : Scene.fog -> order -> scatter -> Segment.t
(** [segment fog order scatter] is the light of what is behind, weakened, and
    what is scattered on the way, where the ray is outside of all bodies: at one
    distance, chosen as the light dwindles. *)

val veil : Scene.fog -> Direct.veil
(** [veil fog] is the part of a light that comes through. *)
