(** Motion blur: what moves while the shutter is open is smeared. *)

open Candor_scene

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the surfaces of [s] that move, unless the shutter only opens
    at time 0. Definitions that nothing uses do not count. *)

val time : Scene.t -> float -> float
(** [time s u] is uniform while the shutter is open, for [u] in \[0;1\[. *)
