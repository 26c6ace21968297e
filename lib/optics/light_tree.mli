(** A choice among many lights, by how much each is likely to give to a point.

    Neighbours are joined two by two up to one root. From the root down, of two
    groups each is taken with a probability in proportion to its power over its
    squared distance, which counts as no less than the group's size. A simple
    form of A. Conty Estevez, C. Kulla,
    {e Importance Sampling of Many Lights with Adaptive Tree Splitting}, Proc.
    ACM Comput. Graph. Interact. Tech. 1(2), 2018. *)

open Candor_space

type light = {
  bounds : Bounds.t;  (** finite; where it is *)
  power : float;  (** finite, not negative; only ratios count *)
}

type t

val make : light array -> t
(** [make lights] is the tree over them, numbered as they stand in the array. *)

val order : t -> int array
(** [order t] are the numbers of all lights, such that those of one leaf stand
    together. Not to be changed. *)

type leaf = {
  first : int;  (** where it begins in [order] *)
  count : int;  (** how many lights it holds: all if 32 at most, else up to 8 *)
  probability : float;  (** with which it is taken, above 0 *)
  rest : float;  (** what is left of [u] for other uses, uniform in \[0;1\[ *)
}

val sample : t -> from:Point.t -> float -> leaf
(** [sample t ~from u] is the leaf that uniform [u] in \[0;1\[ takes at the
    point [from]. *)

val find : t -> from:Point.t -> int -> leaf
(** [find t ~from i] is the leaf that holds entry [i] of [order], with the
    probability with which [sample t ~from] takes it; [rest] is 0. *)
