(** Emission: surfaces that give light are seen shining. *)

open Candor_colour
open Candor_scene

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the materials in use that emit. *)

val radiance : Tracer.hit -> Rgb.t
(** [radiance hit] is what the surface sends by itself to where the ray came
    from: nothing on its inner side, unless it emits from both. *)

type weigh = Path.t -> Tracer.hit -> float
(** How much of it counts, in \[0;1\]: the rest is found in another way. *)

val term : ?weigh:weigh -> unit -> Term.t
(** [term ()] adds what the surface sends by itself, in full unless [weigh] says
    otherwise. *)
