(** Scenes as text that reads as the same scene. *)

open Candor_scene

val to_string : Scene.t -> string
(** [to_string s] is [s] as a scene file. If [s] was read, then reading the text
    gives a scene equal to [s] but for places, number by number and bit by bit.
*)

val pp : Format.formatter -> Scene.t -> unit
(** [pp] prints {!to_string}. *)
