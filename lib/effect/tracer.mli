(** The questions that light paths ask of the scene's surfaces, put by the plan:
    with the time where something moves, and without elsewhere. *)

open Candor_space
open Candor_optics
open Candor_surface

type hit = Skin.t Hit.t

type t = {
  nearest : Tally.t -> Path.t -> Ray.t -> hit option;
      (** where a ray first meets a surface *)
  within : Tally.t -> Path.t -> limit:float -> Ray.t -> hit option;
      (** the same at t ≤ [limit] *)
  blocked : Tally.t -> Path.t -> limit:float -> Ray.t -> bool;
      (** whether it meets one at t ≤ [limit] *)
  meets_any : Tally.t -> Path.t -> (Skin.t -> bool) -> Ray.t -> bool;
      (** whether it meets one of a kind, as if there were no others *)
}

val still : Skin.t Surface.t -> t
(** [still s] sees [s] as it is at time 0. *)

val moving : Skin.t Surface.t -> t
(** [moving s] sees [s] as it is at the time of the path. *)
