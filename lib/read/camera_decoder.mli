(** Cameras. *)

open Candor_scene
open Decode

val camera : Camera.t body
(** [camera] is the body of [(camera ...)]. *)
