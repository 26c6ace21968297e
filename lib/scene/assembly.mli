(** The surfaces of a scene, put together for tracing. *)

open Candor_surface

type skin = {
  material : Material.t;  (** resolved *)
  both_sides : bool;  (** whether it emits from both *)
  place : Place.t;  (** where it is written *)
}
(** What a scene says about a surface besides its shape. *)

val surface : ?math:Math.t -> dress:(skin -> 'm) -> Scene.t -> 'm Surface.t
(** [surface ~dress s] is all of [s]'s surfaces as one group, each with [dress]
    of its skin, met by [math] (default [Stable]). A definition is shared by all
    its uses that give it the same material to inherit (and [both_sides]). *)

type use = { name : string option; material : Material.t; place : Place.t }
(** A material that some surface is made of, with the place that says so: where
    it is named, or else the first surface that has it. *)

val materials_in_use : Scene.t -> use list
(** [materials_in_use s] are the materials that surfaces of [s] are made of,
    each once, in the order first met. Definitions that nothing uses do not
    count. *)

val surfaces_in_use : Scene.t -> Scene.surface list
(** [surfaces_in_use s] are the surfaces of [s], groups and their members
    included, and the definitions that they use, each once, in the order first
    met. *)
