(** The price list of what was measured. *)

open Candor_scene

val v : Scene.t -> file:string -> domains:int -> Budget.t -> Survey.t -> Price.t
(** [v scene ~file ~domains budget survey] is the list of [scene], read from
    [file]. The law, and the predictions, are fitted to the rungs of two samples
    and more: one at the centre has an error of another kind. Errors are [nan]
    where the only rung is of one sample, beside which there is no truth. *)
