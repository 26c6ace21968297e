(** Gloss: rough metal and plastic reflect what shines on them, blurred. *)

open Candor_scene
open Candor_optics

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the materials in use that have gloss. *)

val term : ?veil:Direct.veil -> Area_lights.t -> Tracer.t -> Term.t
(** [term lights tracer] adds to a glossy surface, where paths end, the area
    lights that it reflects: one ray is traced along a direction that the gloss
    itself chooses, and only what it meets of them counts, together with
    {!Soft_shadows}; [veil] takes some of it on the way. (Under indirect light
    {!Indirect} does the same.) *)
