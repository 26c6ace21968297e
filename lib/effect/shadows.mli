(** Shadows: a surface between a light and a point takes its light away. *)

open Candor_scene
open Candor_surface

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the lights of [s] that cast shadows. *)

val reach : Assembly.skin Surface.t -> Light.t -> Direct.reach
(** [reach surface l] is whether nothing of [surface] is between [l] and a hit:
    one shadow ray, to the light itself and not beyond. *)
