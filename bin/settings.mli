(** Options that override what a scene says of its picture. *)

open Candor_scene

type t

val term : t Cmdliner.Term.t
(** [term] is [--size], [--spp], [--depth], [--cutoff], [--seed] and [--filter].
*)

val with_targets : t Cmdliner.Term.t
(** [with_targets] is [--error] and [--time] as well. *)

val choose_samples : t -> bool
(** [choose_samples o] is [true] iff one of [--spp], [--error] and [--time] is
    given. *)

val apply : t -> Scene.t -> Scene.t
(** [apply o s] is [s] with what [o] overrides. *)

val warnings : t -> Candor_effect.Plan.t -> Scene.t -> string list
(** [warnings o plan s] says which effects that [s] calls for [o] switches off.
*)

val domains : int option Cmdliner.Term.t
(** [domains] is [-j]. *)

val duration : float Cmdliner.Arg.conv
(** [duration] is a time in seconds, above 0. *)

val scene : string Cmdliner.Term.t
(** [scene] is the one scene file that a command works on. *)

val read : string -> (Scene.t, Status.t) result
(** [read file] is the scene in [file]; if something is wrong with it, the user
    has been told all of it. *)

val plan : all_effects:bool -> Scene.t -> Candor_effect.Plan.t
val all_effects : bool Cmdliner.Term.t
val math : Candor_surface.Math.t Cmdliner.Term.t
