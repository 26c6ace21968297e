(** The forms in [(scene ...)], and what they come to together. *)

open Candor_scene

type t
(** A scene in the making. *)

val empty : t
(** [empty] is what no forms come to. *)

val form :
  include_:(Notes.t -> Span.t -> string -> t -> t) -> (t -> t) Decode.value
(** [form ~include_] is how a form changes a scene in the making. [include_]
    adds the forms of a file that [(include FILE)] names. *)

val finish : Notes.t -> Span.t -> t -> Scene.t option
(** [finish notes span t] is the scene, all its names known, no definition in a
    cycle, and all of it making {!Sense}; [None] if anything is noted. [span] is
    what to blame for a missing camera. *)
