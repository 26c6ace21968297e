(** Scenes in which nothing is reflected twice. *)

open Candor_scene

val why : Scene.t -> string option
(** [why s] is [Some reason] where it is proved that in [s], if it has nothing
    but mirrors to send light on, no path is reflected more than once; [None]
    where it is not. *)
