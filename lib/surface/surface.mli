(** The five kinds of surface, and the two questions a tracer asks of them.

    {b Laws.} The nearest hit of a group is the least of its members' by (t,
    place). [blocked] is whether [nearest] finds something. Multiplying all
    lengths by a power of two multiplies every [t] by it, bit for bit. What has
    moved by nothing is met as if it stood still, bit for bit. *)

open Candor_space

type 'm t = private
  | Sphere of Sphere.t * 'm
  | Box of Box.t * 'm
  | Triangle of Triangle.t * 'm
  | Quadric of Quadric.t * 'm
  | Group of 'm group
  | Moving of 'm moving  (** one of these, along a line *)

and 'm group

and 'm moving
(** The type for surfaces, each with what its user keeps with it, a material for
    instance. *)

val sphere : Sphere.t -> 'm -> 'm t
val box : Box.t -> 'm -> 'm t
val triangle : Triangle.t -> 'm -> 'm t
val quadric : Quadric.t -> 'm -> 'm t

val group : ?math:Math.t -> 'm t array -> 'm t
(** [group members] is all of [members] as one surface. They count from 0.
    [math] (default [Stable]) is how rays meet the members; groups among them
    have their own. *)

val seen_through : ?transform:Transform.t -> 'm t -> 'm t
(** [seen_through ~transform s] is [s] moved by [transform], sharing everything
    with [s]. A group stays the same group; any other surface becomes the only
    member of one. *)

val moving : velocity:Vec.t -> shutter:float * float -> 'm t -> 'm t
(** [moving ~velocity ~shutter s] is [s] moved by the doubles nearest to
    time·velocity, in the place of [s]: what is a member 3 stays one. Its
    {!bounds} hold it at all times of the [shutter], both ends included; asked
    about at other times, it may be missed. *)

val bounds : 'm t -> Bounds.t
(** [bounds s] is a box that holds [s]; not finite where [s] is unbounded. *)

val cover : 'm t -> depth:int -> Bounds.t list
(** [cover s ~depth] is at most 2^depth boxes that together hold [s]. *)

val nearest :
  'm t ->
  ?limit:float ->
  ?time:float ->
  ?effort:Effort.t ->
  Ray.t ->
  'm Hit.t option
(** [nearest s r] is where [r] first meets [s] at 0 < t ≤ [limit] (default: no
    limit), with all that moves where it stands at [time] (default 0); of
    several at the same t the one of least place. [None] where there is none,
    and for a ray with a coordinate that is not finite or a direction that is
    zero. What it took is added to [effort]. *)

val blocked :
  'm t -> ?time:float -> ?effort:Effort.t -> limit:float -> Ray.t -> bool
(** [blocked s ~limit r] is [nearest s ~limit r <> None], stopping at the first
    hit found. *)

val meets_any :
  'm t -> ?time:float -> ?effort:Effort.t -> ('m -> bool) -> Ray.t -> bool
(** [meets_any s kind r] says whether [r] meets at t > 0 any of [s]'s surfaces
    that carry an [m] with [kind m], as if there were no others. *)
