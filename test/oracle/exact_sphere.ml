(** Spheres in exact arithmetic. *)

open Candor_space
open Exact
open Crossing

let equation (s : Candor_surface.Sphere.t) { origin = o; direction = d } =
  let f = sub o (v (q s.x) (q s.y) (q s.z)) and r = q s.radius in
  ((dot d d, dot f d, dot f f - (r * r)), f, r)

let truth s line =
  let ((a, _, _) as abc), f, r = equation s line in
  let at side root = { at = root; side; part = 0 } in
  let crossings =
    match Exact_root.of_quadratic abc with
    | [ near; far ] -> [ at Side.Outside near; at Side.Inside far ]
    | _ -> []
  in
  let scale = (r * r) + dot f f in
  let band =
    lazy (Q.leq (Q.abs (Exact_root.discriminant abc)) (power (-96) * a * scale))
  in
  let slack = power (-96) * (r + size f) / largest line.direction in
  { crossings; band; slack }

(** [value s p] is |p − centre|² − radius². *)
let value (s : Candor_surface.Sphere.t) p =
  let f = sub p (v (q s.x) (q s.y) (q s.z)) and r = q s.radius in
  dot f f - (r * r)
