(** Triangles in exact arithmetic, ties broken by the simulation of simplicity
    that [Triangle.meet] documents: d moves to d + (ε, ε², ε³). *)

open Candor_space
open Candor_surface
open Exact
open Crossing

let corners (s : Triangle.t) =
  let { Triangle.a; b; c } = s.corners in
  (point a, point b, point c)

(** [normal s] is the normal of [s], of any length. *)
let normal s =
  let a, b, c = corners s in
  cross (sub b a) (sub c a)

let rec first_sign = function
  | [] -> 0
  | x :: rest -> ( match Q.sign x with 0 -> first_sign rest | s -> s)

let edge d p r =
  let m = cross p r in
  first_sign [ dot d m; m.x; m.y; m.z ]

let truth s { origin = o; direction = d } =
  let a, b, c = corners s in
  let n = normal s in
  let across = dot d n in
  let a' = sub a o and b' = sub b o and c' = sub c o in
  let ea = edge d b' c' and eb = edge d c' a' and ec = edge d a' b' in
  if Q.sign across <> 0 && ea <> 0 && ea = eb && eb = ec then
    let side : Side.t = if Q.sign across < 0 then Outside else Inside in
    exactly [ { at = Ratio (dot a' n / across); side; part = 0 } ]
  else exactly []

(** [value s p] is the signed volume over the triangle: > 0 outside. *)
let value s p =
  let a, _, _ = corners s in
  dot (normal s) (sub p a)
