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

val verdict : t -> Object_ray.t -> float -> verdict
(** [verdict h ray t] says whether the point at [t] along the ray is in [h],
    when [t] is off by at most 128 ulp; [Unsure] where rounding could decide
    otherwise. *)

val along : t -> Object_ray.t -> Expansion.t * Expansion.t
(** [along h ray] is (v, w), exactly: the point at [t] is in [h] iff v + t·w ≤
    0. *)

val speed : t -> Object_ray.t -> float
(** [speed h ray] is n·d for the ray's direction d, as if in twice the
    precision: positive on the way out. *)

val depth : t -> Object_ray.t -> float
(** [depth h ray] is c − n·(x − p) for the ray's origin x, as if in twice the
    precision: positive inside. *)
