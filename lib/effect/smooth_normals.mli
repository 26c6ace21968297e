(** Smooth normals: triangles shade as the curved surface they stand for. *)

open Candor_scene

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the triangles in use that have normals of their own. *)
