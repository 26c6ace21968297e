(** Lights. *)

open Candor_scene
open Decode

val light : Light.t body
(** [light] is the body of [(light ...)]. *)
