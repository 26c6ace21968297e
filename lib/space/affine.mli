(** Affine maps of space: three rows of a 4×4 matrix acting on column vectors.
*)

type t = {
  xx : float;
  xy : float;
  xz : float;
  xt : float;
  yx : float;
  yy : float;
  yz : float;
  yt : float;
  zx : float;
  zy : float;
  zz : float;
  zt : float;
}
[@@deriving show, eq, ord]
(** The map (x, y, z) ↦ (xx·x + xy·y + xz·z + xt, …). *)

val identity : t
(** [identity] leaves every point where it is. *)

val point : t -> Point.t -> Point.t
(** [point m p] is the image of the point [p]. *)

val vector : t -> Vec.t -> Vec.t
(** [vector m a] is the image of the displacement [a]: translation left out. *)

val transposed : t -> Vec.t -> Vec.t
(** [transposed m a] is the transpose of [m]'s linear part applied to [a]. With
    the inverse map it takes normals along. *)

val point_error : t -> Point.t -> Vec.t -> Vec.t
(** [point_error m p e] is, for each coordinate, a bound on the error of
    [point m p] when every coordinate of [p] is off by at most that of [e]
    (non-negative). After M. Pharr, W. Jakob, G. Humphreys,
    {e Physically Based Rendering}, 4th ed. (2023), 6.8. *)

val determinant : t -> float
(** [determinant m] is that of the linear part. *)

val after : t -> t -> t
(** [after b a] is the map that does [a] first, then [b]. *)

val inverse : t -> t option
(** [inverse m] is the map that undoes [m]; [None] if it has none (decided
    exactly), or one whose entries are not finite. *)
