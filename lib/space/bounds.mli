(** Axis-parallel bounding boxes, closed on all sides. *)

type t = {
  x0 : float;
  y0 : float;
  z0 : float;
  x1 : float;
  y1 : float;
  z1 : float;
}
[@@deriving show, eq, ord]
(** The points with x0 ≤ x ≤ x1, y0 ≤ y ≤ y1, z0 ≤ z ≤ z1; empty if any low end
    is above its high end. *)

val empty : t
(** [empty] holds no point: from +∞ to −∞. The identity of {!join}. *)

val everything : t
(** [everything] holds all of space: from −∞ to +∞. *)

val v : Point.t -> Point.t -> t
(** [v low high] is the box between two corners. *)

val of_points : Point.t list -> t
(** [of_points ps] is the least box that holds all of [ps]. *)

val join : t -> t -> t
(** [join a b] is the least box that holds both. *)

val meet : t -> t -> t
(** [meet a b] is what both hold. *)

val widen : float -> t -> t
(** [widen e b] is [b] grown by [e ≥ 0] on every side, rounded outwards. *)

val is_finite : t -> bool
(** [is_finite b] is [true] iff all six ends are finite. *)

val mem : Point.t -> t -> bool
(** [mem p b] is [true] iff [b] holds [p]. *)

val low : t -> Point.t
(** [low b] is the corner (x0, y0, z0). *)

val high : t -> Point.t
(** [high b] is the corner (x1, y1, z1). *)

val transform : Wide_affine.t -> t -> t
(** [transform m b] is a box that holds the image of every point of [b]; where
    [b] is not finite, neither is it. *)
