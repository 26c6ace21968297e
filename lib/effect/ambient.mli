(** Ambient light: a constant that stands in for all light that bounces. *)

open Candor_colour
open Candor_scene

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] is what in [s] asks for it: [(ambient RGB)], where something has a
    matte part. *)

val term : Rgb.t -> Term.t
(** [term l] adds albedo·[l] where a matte part is seen. *)
