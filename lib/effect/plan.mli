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

val forcing : Effect.t list -> Scene.t -> t
(** [forcing es s] is [of_scene s] with [es] on too. {b Law.} It renders the
    same bits as [of_scene s]. *)

val all : Scene.t -> t
(** [all s] has every effect on. {b Law.} It renders the same bits as
    [of_scene s]. *)

val without : Effect.t -> Scene.t -> t
(** [without e s] is [of_scene s] with [e] off although [s] calls for it: what
    is left is assembled as if [e] were unknown. *)

val status : t -> Effect.t -> status

val is_on : t -> Effect.t -> bool
(** [is_on p e] is [true] unless [e] is [Off]. *)

val is_called : t -> Effect.t -> bool
(** [is_called p e] is [true] iff [e] is [Called]. *)

val is_forced : t -> bool
(** [is_forced p] is [true] iff [p] is {!all} of some scene. *)

(** {1 Depth} *)

type bound =
  | Steps of { most : int; why : string }
      (** no path has more reflections, refractions and bounces *)
  | Unbounded of { why : string }
[@@deriving show, eq]

val depth : t -> bound
(** [depth p] bounds the depth of paths. *)

val cut_at_once : t -> Scene.t -> Effect.t list
(** [cut_at_once p s] are the effects that [s] calls for and that a depth of 0
    leaves out. *)

(** {1 Assembling} *)

type equation = {
  terms : (Effect.t * Term.t) list;
      (** in the order in which they are summed *)
  segment : Segment.t option;  (** what happens between surfaces, if anything *)
  sky : Path.t -> Candor_space.Vec.t -> Candor_colour.Rgb.t;
      (** what a path finds where there is no surface *)
  tracer : Tracer.t;
}
(** The light equation of a scene. *)

val compile :
  t -> Scene.t -> Candor_optics.Skin.t Candor_surface.Surface.t -> equation
(** [compile p s surface] is made of the effects that are on; those that are off
    leave nothing behind. *)

val is_random : t -> bool
(** [is_random p] is [true] iff something in [p] is left to chance, other than
    where in a pixel its samples are. *)
