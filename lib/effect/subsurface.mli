(** Subsurface scattering: light wanders inside translucent bodies. *)

open Candor_colour
open Candor_scene

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the translucent materials in use. *)

type scatter = Tally.t -> Path.t -> Receiver.t -> Rgb.t
(** The light of lights that a point sends to the viewer. *)

val segment : Tracer.t -> scatter -> Segment.t
(** [segment tracer scatter] walks at random through the body that the path is
    in, from one scattering to the next, until a surface is met. What the walk
    has lost ends it by chance, without loss in the mean. [scatter] is for the
    lights that {!may_reach} the inside, asked at each scattering; area lights
    are left for the walk to meet. *)

val may_reach : moving:bool -> Tracer.t -> Light.t -> bool
(** [may_reach ~moving tracer l] is [true] iff [l] stands in a translucent body,
    where surfaces that block light leave any to it. Where surfaces are [moving]
    and for lights that cast no shadows, iff it stands anywhere. *)
