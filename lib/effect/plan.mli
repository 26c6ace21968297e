(** Which effects a scene calls for: derived from it, never declared. *)

open Candor_scene

type status =
  | Called of Reason.t list  (** on: by these *)
  | Forced  (** on although nothing asks for it ([--all-effects]) *)
  | Off
[@@deriving show, eq, ord]

type t [@@deriving show, eq]

val of_scene : Scene.t -> t
(** [of_scene s] is the least plan that renders [s]. *)

val all : Scene.t -> t
(** [all s] has every effect on. {b Law.} It renders the same bits as
    [of_scene s]. *)

val status : t -> Effect.t -> status

val is_on : t -> Effect.t -> bool
(** [is_on p e] is [true] unless [e] is [Off]. *)

val depth : t -> int
(** [depth p] bounds the reflections along any path: 0 if nothing reflects, else
    the scene's own limit. *)

(** {1 Assembling} *)

type terms = (Effect.t * Term.t) list

val compile : t -> Scene.t -> Assembly.skin Candor_surface.Surface.t -> terms
(** [compile p s surface] are the terms of the effects that are on, in the order
    in which they are summed; those that are off leave nothing behind. Shadows
    have no term of their own: they decide which lights reach a point. *)
