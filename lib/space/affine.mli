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

val point_error : t -> Point.t -> Vec.t
(** [point_error m p] is, for each coordinate, a bound on the rounding error of
    [point m p]. After M. Pharr, W. Jakob, G. Humphreys,
    {e Physically Based Rendering}, 4th ed. (2023), 6.8. *)

val spread : t -> Vec.t -> Vec.t
(** [spread m e] is, for each coordinate, a bound on how far the exact image of
    a point moves when every coordinate of the point does by at most that of [e]
    (non-negative). *)

(** {1 Columns} *)

type columns = { x : Vec.t; y : Vec.t; z : Vec.t; t : Vec.t }
(** The images of the three unit vectors, and the translation. *)

val columns : t -> columns
(** [columns m] is [m] by columns. *)

val of_columns : columns -> t
(** [of_columns c] is the map with the columns [c]. *)

val zero : t
(** [zero] is the map whose numbers are all zero. *)
