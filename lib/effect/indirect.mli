(** Indirect light: light that bounces off matte and glossy surfaces is followed
    from there. *)

open Candor_scene
open Candor_optics

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] is [(indirect-light)], where light that falls on something can be
    seen. *)

val term : Scattering.t -> Limit.t -> Term.t
(** [term scattering limit] adds what comes along one direction, chosen as
    [scattering] samples, over the chance of that: path tracing, after J. T.
    Kajiya, {e The Rendering Equation}, 1986. *)
