(** Points: places in the scene, in scene units. *)

type t = { x : float; y : float; z : float } [@@deriving show, eq, ord]

val v : float -> float -> float -> t
(** [v x y z] is the point with these coordinates. *)

val origin : t
(** [origin] is [v 0. 0. 0.]. *)

val add : t -> Vec.t -> t
(** [add p a] is [p] moved by [a]. *)

val sub : t -> t -> Vec.t
(** [sub p q] is the vector from [q] to [p]. *)

val along : t -> Vec.t -> float -> t
(** [along p d t] is [p + t·d], each coordinate rounded once. *)

val ldexp : int -> t -> t
(** [ldexp e p] is [p] with each coordinate times 2^e, exact unless it leaves
    the range of doubles. *)

val is_finite : t -> bool
(** [is_finite p] is [true] iff no coordinate is infinite or not a number. *)

val get : t -> int -> float
(** [get p i] is coordinate [i] of [0], [1], [2] (any other [i] counts as [2]).
*)
