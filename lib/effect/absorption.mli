(** Absorption: coloured glass takes light away, the more of it the longer the
    way through. *)

open Candor_scene

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the materials of glass in use that absorb. *)

val segment : Segment.t
(** [segment] lets through what {!Candor_optics.Medium.transmittance} says of
    the body that the path is in. *)

val veil : Direct.veil
(** [veil] is the same on the way to a light inside that body. *)
