(** The price list of what was measured. *)

open Candor_scene

val v : Scene.t -> file:string -> domains:int -> Budget.t -> Survey.t -> Price.t
(** [v scene ~file ~domains budget survey] is the list of [scene], read from
    [file]. The law is fitted to rungs whose samples are powers of two: in
    between, low-discrepancy points are less even than their number lets expect;
    and one sample, at the centre, has an error of another kind. Predictions are
    of the least power of two that brings the error down to what is asked for,
    and of the seconds that it takes. Errors are [nan] where the only rung is of
    one sample, beside which there is no truth. *)

val error_at : Price.t -> int -> float option
(** [error_at p spp] is the error that the law of [p]'s ladder says [spp]
    samples leave, if there is one. *)
