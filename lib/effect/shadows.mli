(** Shadows: a surface between a light and a point takes its light away. *)

open Candor_scene

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the lights of [s] that cast shadows. *)

val reach : Tracer.t -> Light.t -> Direct.reach
(** [reach tracer l] is whether nothing is between [l] and a point: one shadow
    ray, to the light itself and not beyond. *)
