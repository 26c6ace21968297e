(** Affine maps whose twelve numbers are sums of two doubles, so that chains of
    transforms do not drift.

    A point or vector is taken and given as a pair too: what doubles hold of it
    and the rest, which is below half an ulp. Results are within 2^-100 of the
    sum of the absolute products that they are made of. *)

type t = private { high : Affine.t; low : Affine.t; mild : bool }
(** The map [high + low], entry by entry; [low] is at most half an ulp of
    [high]. [mild] says whether the linear part of [high] {!Error_free.is_mild}.
*)

val of_affine : Affine.t -> t
(** [of_affine m] is [m] exactly. *)

val after : t -> t -> t
(** [after b a] is the map that does [a] first, then [b]. *)

val inverse : Affine.t -> t option
(** [inverse m] is the map that undoes [m], each entry as near as two doubles
    come; [None] if there is none (decided exactly), or if its numbers are not
    finite. *)

val point : t -> Point.t -> Vec.t -> Point.t * Vec.t
(** [point m p r] is the image of the point [p + r]. *)

val point_error : t -> Point.t -> Vec.t -> Vec.t
(** [point_error m p e] is, for each coordinate, a bound on the error of the sum
    [point m p r] when every coordinate of [p + r] is off by at most that of [e]
    (non-negative). *)

val vector : t -> Vec.t -> Vec.t -> Vec.t * Vec.t
(** [vector m a r] is the image of the displacement [a + r]. *)

val ray :
  t -> Point.t -> Vec.t -> Vec.t -> Vec.t -> Point.t * Vec.t * Vec.t * Vec.t
(** [ray m p r a s] is what [point m p r] and [vector m a s] are, for less. *)

val is_finite : t -> bool
(** [is_finite m] is [true] iff all numbers of [m] are finite. *)
