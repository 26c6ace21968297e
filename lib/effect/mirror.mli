(** Mirror reflection: of mirrors, and of the glaze on a glazed surface. *)

open Candor_space
open Candor_scene

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the materials in use that reflect. *)

val direction : _ Candor_surface.Hit.t -> Vec.t -> Vec.t
(** [direction hit view] is where the viewer along [view] is reflected, above
    the surface. *)

val sharp : Path.journey -> Path.journey
(** [sharp j] is [j] with {!Path.Sharp} as its arrival. *)

val term : Limit.t -> Term.t
(** [term limit] adds mirror·(what comes along r = 2(n·v)n − v), by recursion.
*)
