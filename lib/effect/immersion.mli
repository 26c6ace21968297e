(** Which bodies of glass a camera is in. *)

open Candor_space
open Candor_scene

val v : Tracer.t -> Path.t -> Ray.t -> Material.t list
(** [v tracer path ray] are the transparent bodies around the origin of [ray],
    innermost first: those that it leaves without having entered. *)
