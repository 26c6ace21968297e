(** The surfaces of a scene that send out light: its area lights. *)

open Candor_colour

type t = Primitives.t
(** A sphere, box, triangle or quadric whose material emits. *)

val of_scene : Scene.t -> t list
(** [of_scene s] is every emitting primitive of [s], each use of a shared
    definition counted by itself, in the order of their paths. *)

val radiance : t -> Rgb.t
(** [radiance e] is what leaves [e] in every direction, from its outer side or
    from both as {!Primitives.t} says; never black. *)
