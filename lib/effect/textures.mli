(** Textures: colours that vary over a surface. *)

open Candor_scene

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the materials in use whose colour varies. The colours of all
    others are looked up once, before the first ray. *)
