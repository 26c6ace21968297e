(** Bounding volume hierarchies over any kind of item.

    Built by the surface-area heuristic on bins (I. Wald,
    {e On fast Construction of SAH-based Bounding Volume Hierarchies}, 2007),
    the same tree for the same items in the same order. *)

open Candor_space

type 'a t

val make : bounds:('a -> Bounds.t) -> 'a array -> 'a t
(** [make ~bounds items] is a hierarchy over [items], in time O(n log n) even
    when all centres coincide. Items whose bounds are not finite are kept
    outside of the tree and visited first. *)

val bounds : 'a t -> Bounds.t
(** [bounds h] is a box that holds every item; empty if there is none. *)

type probe
(** A ray as boxes are met by it. *)

val probe : Object_ray.t -> probe
(** [probe ray] serves for all hierarchies that [ray] is to visit. *)

val visit :
  'a t ->
  probe ->
  Cursor.t ->
  'context ->
  ('context -> int -> 'a -> bool) ->
  bool
(** [visit h (probe ray) cursor context test] calls [test context i item] on
    every item whose bounds [ray] meets at 0 ≤ t ≤ cursor.t, nearer ones first
    as far as the tree knows, until one answers [true] or none is left; it is
    whether one did. [i] is the item's index in what {!make} was given. [test]
    may move [cursor]; boxes beyond it are passed over.

    Conservative: no item that the ray, as a sum of doubles, meets is left out
    for rounding. *)

val cover : 'a t -> depth:int -> Bounds.t list
(** [cover h ~depth] is at most 2^depth boxes that together hold all items; just
    [bounds h] where some are not bounded. *)
