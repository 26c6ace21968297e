(** Half-spaces that cut surfaces to size. *)

open Candor_number
open Candor_space

type t = {
  nx : float;
  ny : float;
  nz : float;
  px : float;
  py : float;
  pz : float;
  c : float;
}
[@@deriving show, eq, ord]
(** The points x with n·(x − p) ≤ c, the plane itself included. *)

val of_bounds : Bounds.t -> t list
(** [of_bounds b] are the half-spaces whose common part is [b], leaving out the
    ends at infinity. *)

type verdict = In | Out | Unsure

val verdict : t -> Point.t -> Vec.t -> float -> verdict
(** [verdict h o d t] says whether the point at [t] along the ray is in [h],
    when [t] is off by at most 128 ulp; [Unsure] where rounding could decide
    otherwise. *)

val along : t -> Point.t -> Vec.t -> Expansion.t * Expansion.t
(** [along h o d] is (v, w), exactly: the point at [t] is in [h] iff v + t·w ≤
    0. *)

val normal : t -> Double_double.vec
(** [normal h] is n, which points out of [h] and need not have length 1. *)

val depth : t -> Point.t -> Double_double.t
(** [depth h x] is c − n·(x − p), in double-double: positive inside, in units of
    n's length. *)
