(** Polynomials of degree two about a centre: F(x) = yᵀAy + 2g·y + k with y = x
    − centre. *)

open Candor_number
open Candor_space

type t = private {
  cx : float;
  cy : float;
  cz : float;
  axx : float;
  ayy : float;
  azz : float;
  axy : float;
  axz : float;
  ayz : float;
  gx : float;
  gy : float;
  gz : float;
  k : float;
  a_size : float;  (** at least the Euclidean norm of A's entries *)
  g_size : float;  (** at least the Euclidean norm of g *)
}
[@@deriving show, eq, ord]

val of_shape : Quadric_shape.t -> t
(** [of_shape s] is the polynomial that [s] means. *)

val is_constant : t -> bool
(** [is_constant f] is [true] iff A and g are zero. *)

val is_linear : t -> bool
(** [is_linear f] is [true] iff A is zero. *)

val center : t -> Point.t
(** [center f] is the point that [f] is written about. *)

val slope : t -> Vec.t
(** [slope f] is g, half the gradient at the centre. *)

val times : t -> Vec.t -> Vec.t
(** [times f y] is A·y. *)

val gradient : t -> Vec.t -> Vec.t
(** [gradient f y] is half the gradient at offset [y] from the centre. *)

val gradient_size : t -> Vec.t -> Vec.t
(** [gradient_size f y] is the sum of the absolute terms that each component of
    {!gradient} adds up: its rounding error is at most 2^-50 of that. *)

(** {1 In twice the precision}

    Places and directions are sums v + v' of two vectors, the second below an
    ulp of the first; results are off by at most 2^-100 of the sum of their
    absolute terms. *)

val value : t -> Vec.t -> Vec.t -> Error_free.t
(** [value f y y'] is F at offset [y + y'] from the centre. *)

val rise : t -> Vec.t -> Vec.t -> Vec.t -> Vec.t -> Error_free.t
(** [rise f y y' d d'] is half the derivative of F there along [d + d']. *)

val bend : t -> Vec.t -> Vec.t -> Error_free.t
(** [bend f d d'] is (d + d')ᵀA(d + d'), half the second derivative. *)

(** {1 Along a line, exactly}

    a·t² + 2b·t + c = F at offset p + t·d. *)

val along_exactly :
  t -> Expansion.vec -> Expansion.vec -> Expansion.t * Expansion.t * Expansion.t
(** [along_exactly f p d] is (a, b, c). *)
