(** Mirror reflection: of mirrors, and of the glaze on a glazed surface. *)

open Candor_scene

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the materials in use that reflect. *)

val term : depth:int -> cutoff:float -> Term.t
(** [term ~depth ~cutoff] adds mirror·(what comes along r = 2(n·v)n − v), by
    recursion, until the path has had [depth] reflections or its largest
    throughput component falls below [cutoff]. What is cut adds nothing, and is
    counted. *)
