(** Axis-parallel boxes with closed faces. *)

open Candor_space

type t = private Bounds.t [@@deriving show, eq, ord]
(** The faces of a box; flat in at most one axis. *)

val make : min:Point.t -> max:Point.t -> (t, string) result
(** [make ~min ~max] is the box between these corners; [Error why] if [min] is
    above [max] on an axis, equal to it on two, or beyond 2^400. *)

val bounds : t -> Bounds.t
(** [bounds b] is [b] itself. *)

val meet : t -> Object_ray.t -> Contact.t -> Cursor.t -> Contact.t
(** [meet b ray left cursor] is the first contact of [ray] with the faces of [b]
    within [cursor], which moves there. The part is 2·axis, plus 1 for the high
    face; where faces tie, the lowest axis wins. A ray that [left] the box
    outwards never meets it again. Decisions are exact; t is within 2 ulp. *)

val locate : t -> Object_ray.t -> float -> Contact.t -> Local.t
(** [locate b ray t contact] is the point of the contact's face at [t], within
    the face exactly. uv runs over the face from 0 to 1. *)
