(** The roots of a·t² + 2b·t + c, and on which side of a plane they are. *)

open Candor_number

(** With r = −(b + sign(b)·√(b² − ac)): *)
type t = First  (** c/r, the only root if a = 0 *) | Second  (** r/a *)

val falls : b:float -> t -> bool
(** [falls ~b root] is [true] iff the polynomial falls through zero at [root]: a
    ray that meets the surface there comes from outside. *)

val is_within :
  Expansion.t * Expansion.t * Expansion.t ->
  falling:bool ->
  Expansion.t * Expansion.t ->
  bool
(** [is_within (a, b, c) ~falling (v, w)] is whether the root t at which the
    polynomial falls (or else rises) satisfies v + t·w ≤ 0, decided exactly. *)
