(** Depth of field: what is not at the distance of focus is blurred. *)

open Candor_scene

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] is the camera, if it has a lens of more than a point. *)

val lens : Scene.t -> Camera.lens
(** [lens s] is the camera's lens, or one of a single point. *)
