open Candor_space
open Candor_surface
open Candor_number
open Candor_oracle
open Candor_surface_families
open QCheck2

let half_space =
  let open Gen in
  let number = oneof [ Draw.small 4; Draw.coordinate ] in
  let* n = Draw.vec number and* a = Draw.point number and* c = number in
  return
    { Half_space.nx = n.x; ny = n.y; nz = n.z; px = a.x; py = a.y; pz = a.z; c }

(* {1 Rays, whole and in groups} *)

let through_group (ray : Object_ray.t) =
  let open Gen in
  let* axis = Draw.unit and* degrees = Draw.uniform (-180.) 180. in
  let* a = Draw.vec (Draw.uniform (-9.) 9.) in
  let steps = [ Transform.Translate a; Rotate { axis; degrees } ] in
  let m = Made.get "transform" (Transform.of_steps steps) in
  return (Object_ray.through (Transform.backward m) ray)

let ray =
  Gen.(
    let* ray = map Object_ray.of_ray Draw.ray and* whole = bool in
    if whole then return ray else through_group ray)

let origin (r : Object_ray.t) = Exact.(add (point r.origin) (vec r.origin_low))

let direction (r : Object_ray.t) =
  Exact.(add (vec r.direction) (vec r.direction_low))

let show_ray (r : Object_ray.t) =
  Printf.sprintf "ray from %s + %s along %s + %s" (Draw.show_point r.origin)
    (Draw.show_vec r.origin_low)
    (Draw.show_vec r.direction)
    (Draw.show_vec r.direction_low)

let normal (h : Half_space.t) = Exact.(v (q h.nx) (q h.ny) (q h.nz))
let anchor (h : Half_space.t) = Exact.(v (q h.px) (q h.py) (q h.pz))

(* v and w of v + t·w ≤ 0 *)
let exact_terms h ray =
  let open Exact in
  ( dot (normal h) (sub (origin ray) (anchor h)) - q h.Half_space.c,
    dot (normal h) (direction ray) )

(* {1 Laws} *)

let expansion_is x y =
  Expansion.sign x = Q.sign y && Exact.within 1. (Expansion.to_float x) y

let along_exactly (h, ray) =
  let v, w = Half_space.along h ray in
  let v', w' = exact_terms h ray in
  expansion_is v v' && expansion_is w w'

(* A verdict that is sure is right for every t within 128 ulp. *)
let verdict_is_right ((h, ray), (t, ulps)) =
  let near = t +. (ulps *. Exact.ulp t) in
  let v, w = exact_terms h ray in
  let value = Q.add v (Q.mul w (Exact.q near)) in
  match Half_space.verdict h ray t with
  | In -> Q.sign value <= 0
  | Out -> Q.sign value > 0
  | Unsure -> true

(* The sum of |n_i|·|a_i| *)
let terms h (a : Exact.vec) =
  let n = normal h in
  Exact.(Q.abs (n.x * a.x) + Q.abs (n.y * a.y) + Q.abs (n.z * a.z))

(* As if in twice the precision, and then rounded. *)
let is_wide found truth terms =
  Q.leq
    Exact.(Q.abs (q found - truth))
    Exact.((power (-98) * terms) + (power (-52) * Q.abs truth) + power (-1060))

let depth_is_exact_to_double_double (h, ray) =
  let value, _ = exact_terms h ray in
  is_wide (Half_space.depth h ray) (Q.neg value)
    Exact.(terms h (sub (origin ray) (anchor h)) + Q.abs (q h.Half_space.c))

let speed_is_exact_to_double_double (h, ray) =
  let _, speed = exact_terms h ray in
  is_wide (Half_space.speed h ray) speed (terms h (direction ray))

(* Out along the normal, in against it. *)
let signs () =
  let h =
    { Half_space.nx = 0.; ny = 2.; nz = 0.; px = 0.; py = 1.; pz = 0.; c = 4. }
  in
  let ray y dy = Object_ray.v (Point.v 5. y 5.) (Vec.v 1. dy 1.) in
  let check what expected found =
    Alcotest.(check (float 0.)) what expected found
  in
  check "depth inside" 4. (Half_space.depth h (ray 1. 1.));
  check "depth on the plane" 0. (Half_space.depth h (ray 3. 1.));
  check "depth outside" (-2.) (Half_space.depth h (ray 4. 1.));
  check "speed on the way out" 6. (Half_space.speed h (ray 1. 3.));
  check "speed on the way in" (-6.) (Half_space.speed h (ray 1. (-3.)))

let of_bounds () =
  let b = Bounds.v (Point.v 0. 1. 2.) (Point.v 3. infinity 5.) in
  let cuts = Half_space.of_bounds b in
  Alcotest.(check int) "one end at infinity is left out" 5 (List.length cuts);
  let mem (q : Point.t) =
    List.for_all
      (fun h ->
        let v, _ = exact_terms h (Object_ray.v q (Vec.v 1. 0. 0.)) in
        Q.sign v <= 0)
      cuts
  in
  List.iter
    (fun q ->
      Alcotest.(check bool) (Draw.show_point q) (Bounds.mem q b) (mem q))
    Point.
      [
        v 0. 1. 2.;
        v 3. 1e300 5.;
        v (-0.) 1. 2.;
        v (-5e-324) 1. 2.;
        v 1. 0.5 3.;
        v 1. 2. (Float.succ 5.);
        v (Float.succ 3.) 2. 3.;
      ]

let show (h, ray) = Half_space.show h ^ "\n" ^ show_ray ray
let both = Gen.pair half_space ray

(* A place along a ray, and how far it may be off; now and then next to the
   plane. *)
let places =
  let open Gen in
  let* h, ray = both in
  let* t = oneof [ map Float.abs (Draw.small 9); Draw.wide (-8.) 8. ] in
  let* ulps = Draw.uniform (-128.) 128. and* off = Draw.uniform (-64.) 64. in
  let v, w = exact_terms { h with c = 0. } ray in
  let there = Q.to_float (Q.add v (Q.mul w (Exact.q t))) in
  let+ near = bool in
  let c = there *. (1. +. (off *. 0x1p-50)) in
  (((if near && Float.is_finite c then { h with c } else h), ray), (t, ulps))

let suite =
  ( "half-space",
    [
      Law.law ~count:5000 ~print:show "its terms along a ray are exact" both
        along_exactly;
      Law.law ~count:8000
        ~print:(fun (x, (t, k)) ->
          Printf.sprintf "%s\nt = %h, %g ulp off" (show x) t k)
        "a verdict that is sure is right for t within 128 ulp" places
        verdict_is_right;
      Law.law ~count:8000 ~print:show
        "the depth of a point is right to double-double" both
        depth_is_exact_to_double_double;
      Law.law ~count:8000 ~print:show
        "the speed is right in twice the precision" both
        speed_is_exact_to_double_double;
      Law.example "depth is positive inside, speed on the way out" signs;
      Law.example "those of a box hold what the box holds" of_bounds;
    ] )
