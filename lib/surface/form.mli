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

val gradient : t -> Vec.t -> Vec.t
(** [gradient f y] is half the gradient at offset [y] from the centre. *)

val value : t -> Point.t -> float
(** [value f p] is F at [p], computed as if in twice the precision and rounded:
    off by at most 2^-53 of itself and 2^-100 of the sum of its absolute terms.
*)

(** {1 Along a line}

    a·t² + 2b·t + c = F at offset p + t·d. *)

type quadratic = {
  a : Double_double.t;
  b : Double_double.t;
  c : Double_double.t;
}

val along : t -> Double_double.vec -> Double_double.vec -> quadratic
(** [along f p d] is F on the line from offset [p] along [d], in double-double.
*)

val along_exactly :
  t -> Expansion.vec -> Expansion.vec -> Expansion.t * Expansion.t * Expansion.t
(** [along_exactly f p d] is the same (a, b, c), exactly. *)
