(** Surfaces, and definitions of such. *)

open Candor_scene
open Decode

val cases : (string * Scene.surface body) list
(** [cases] is what each kind of surface reads like, by its head. *)

val definition : (string * Span.t * Scene.surface list option) body
(** [definition] is [NAME surface...], at least one. *)
