(** The shape of a bounding volume hierarchy: boxes within boxes, packed.

    Built top down by the surface-area heuristic on bins (I. Wald,
    {e On fast Construction of SAH-based Bounding Volume Hierarchies}, 2007):
    always the same tree for the same boxes in the same order. *)

type t = {
  boxes : Box_array.t;  (** the box of each node; node 0 is the root *)
  links : int array;  (** what each node leads to: see {!leaf} *)
  order : int array;  (** the items, leaf after leaf *)
}

val build : Box_array.t -> int array -> t
(** [build boxes items] divides [items], which are places in [boxes], all
    finite. No node if there is no item. [items] is given up. Takes time O(n log
    n), and no path is longer than about 40 + log₂ n, even when all centres
    coincide. *)

(** {1 Links}

    The low child of inner node n is node n + 1. *)

val is_leaf : int -> bool

val first : int -> int
(** [first l] is where the items of a leaf begin in [order]. *)

val count : int -> int
(** [count l] is how many items a leaf has. *)

val is_open : int -> bool
(** [is_open l] is whether an inner node is so large beside those that it is in
    that its box need not be met: its children do as well. No root is open. *)

val may_be_open : t -> bool
(** [may_be_open t] is [false] only if no node of [t] is open: large trees have
    none. *)

val high_child : int -> int
(** [high_child l] is an inner node's other child. *)

val axis : int -> int
(** [axis l] is the axis that an inner node is divided along. *)
