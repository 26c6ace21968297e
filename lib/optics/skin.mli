(** What a traced surface carries. *)

open Candor_surface
open Candor_scene

type t = {
  material : Material.t;
  both_sides : bool;  (** whether it emits from both *)
  place : Place.t;  (** where it is written *)
  lobes : Lobes.at;  (** those of [material] *)
}

val surface : ?math:Math.t -> Scene.t -> t Surface.t
(** [surface s] is all of [s]'s surfaces as one group, met by [math] (default
    [Stable]): see {!Assembly.surface}. *)
