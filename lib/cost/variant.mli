(** The settings that a scene has prices for, and how to render under them. *)

open Candor_scene
open Candor_trace

type t

(** Sets of samples, independent of each other. *)
type seeding = First  (** the scene's own seed *) | Second

val setting : t -> Price.setting

val own : Scene.t -> int -> t
(** [own s n] is [s] as it is, at [n] samples a pixel. *)

val others : Scene.t -> t list
(** [others s] are all settings but samples that say something about [s]: naive
    math, no single light, no single effect, lesser depth, a cutoff, another
    sampler. *)

val compile : t -> spp:int -> seeding -> Pixel.t
(** [compile v ~spp seeding] is [v] made ready to render at [spp]. *)
