(** The surfaces of a scene, put together for tracing. *)

open Candor_surface

type skin = { material : Material.t; place : Place.t }
(** What a traced surface carries: its material, resolved, and where it is
    written. *)

val surface : ?math:Math.t -> Scene.t -> skin Surface.t
(** [surface s] is all of [s]'s surfaces as one group, met by [math] (default
    [Stable]). A definition is shared by all its uses that give it the same
    material to inherit. *)

type use = { name : string option; material : Material.t; place : Place.t }
(** A material that some surface is made of, with the place that says so: where
    it is named, or else the first surface that has it. *)

val materials_in_use : Scene.t -> use list
(** [materials_in_use s] are the materials that surfaces of [s] are made of,
    each once, in the order first met. Definitions that nothing uses do not
    count. *)
