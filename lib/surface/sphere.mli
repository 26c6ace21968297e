(** Spheres. *)

open Candor_space

type t = private { x : float; y : float; z : float; radius : float }
[@@deriving show, eq, ord]
(** The points at distance [radius] of the centre (x, y, z); outside is away
    from the centre. *)

val make : center:Point.t -> radius:float -> (t, string) result
(** [make ~center ~radius] is that sphere; [Error why] unless 2^-400 ≤ radius ≤
    2^400 and the centre is within 2^400 of 0 on every axis. *)

val center : t -> Point.t
(** [center s] is the centre. *)

val bounds : t -> Bounds.t
(** [bounds s] is a box that holds [s]. *)

val meet : t -> Object_ray.t -> Contact.t -> Cursor.t -> Contact.t
(** [meet s ray left cursor] is the first contact of [ray] with [s] within
    [cursor], which moves there. [left] is the contact that the ray starts from,
    if it starts on [s]: then the root at 0 is taken out of the equation instead
    of being told apart from 0 by a tolerance.

    Two tiers: plain doubles where proven bounds decide, {!Double_double} in the
    band around tangency. Decisions are exact outside a relative band of 2^-96.
*)

val locate : t -> Object_ray.t -> float -> Contact.t -> Local.t
(** [locate s ray t contact] is the point of [s] at [t] along the ray, moved
    onto the sphere by one Newton step along its radius. From far away, where
    the doubles near [t] are further apart than the sphere is wide, the way to
    it starts from the point of the ray nearest to the centre. *)
