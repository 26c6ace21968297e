(* What the library promises of every kind of surface, all in one place. *)

open Candor_surface_families

(** [ulps kind family] is how many ulps a t may be off, besides a slack of 2^-96
    of size and distance, in units of the direction. *)
let ulps kind family =
  match kind with
  | "box" -> 2.
  | "triangle" | "polygon" -> 4.
  | "quadric"
    when List.mem family Quadrics.[ k8.Candor_oracle.Family.name; whole.name ]
    ->
      4.
  | "quadric" | "clip" -> 6.
  | _ -> 5. (* spheres, and what is in groups *)

(** [blur] is what is forgiven of a ray that enters groups, as a share of the
    sizes that add up to a coordinate in the space of each group around. *)
let blur = 0x1p-96

(** [offset kind family] is how far a ray may start from the hit that it leaves,
    in 2^-53 of the coordinates of hit and surface. What is in a group owes more
    to its transform. Double planes and lone points have no gradient to go by.
*)
let offset kind family =
  match kind with
  | "nested" -> 64.
  | "quadric" when String.equal family Quadrics.whole.name -> infinity
  | _ -> 8.
