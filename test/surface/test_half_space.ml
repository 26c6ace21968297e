open Candor_space
open Candor_surface
open Candor_number
open Candor_oracle
open QCheck2

let half_space =
  let open Gen in
  let number = oneof [ Draw.small 4; Draw.coordinate ] in
  let* n = Draw.vec number and* a = Draw.point number and* c = number in
  return
    { Half_space.nx = n.x; ny = n.y; nz = n.z; px = a.x; py = a.y; pz = a.z; c }

let exact_terms (h : Half_space.t) ray =
  let { Crossing.origin = o; direction = d } = Crossing.line ray in
  let open Exact in
  let n = v (q h.nx) (q h.ny) (q h.nz) and a = v (q h.px) (q h.py) (q h.pz) in
  (dot n (sub o a) - q h.c, dot n d)

let expansion_is x y =
  Expansion.sign x = Q.sign y && Exact.within 1. (Expansion.to_float x) y

let given (r : Ray.t) = Object_ray.v r.origin r.direction

let along_exactly (h, (ray : Ray.t)) =
  let v, w = Half_space.along h (given ray) in
  let v', w' = exact_terms h ray in
  expansion_is v v' && expansion_is w w'

(* A verdict that is sure is right for every t within 8 ulp. *)
let verdict_is_right ((h, (ray : Ray.t)), (t, ulps)) =
  let near = t +. (ulps *. Exact.ulp t) in
  let v, w = exact_terms h ray in
  let value = Q.add v (Q.mul w (Exact.q near)) in
  match Half_space.verdict h (given ray) t with
  | In -> Q.sign value <= 0
  | Out -> Q.sign value > 0
  | Unsure -> true

let depth_is_exact_to_double_double (h, (ray : Ray.t)) =
  let value, _ = exact_terms h ray in
  let found = Half_space.depth h (given ray) in
  let { Point.x; y; z } = ray.origin in
  let size n p x = Q.abs Exact.(q n * (q x - q p)) in
  let terms =
    Q.add (size h.nx h.px x)
      (Q.add (size h.ny h.py y)
         (Q.add (size h.nz h.pz z) (Q.abs (Exact.q h.c))))
  in
  let error = Q.abs Exact.(q found + value) in
  Q.leq error
    Exact.((power (-98) * terms) + (power (-52) * Q.abs value) + power (-1060))

let speed_is_exact_to_double_double (h, (ray : Ray.t)) =
  let _, speed = exact_terms h ray in
  let d = ray.direction in
  let size n d = Q.abs Exact.(q n * q d) in
  let terms = Q.add (size h.nx d.x) (Q.add (size h.ny d.y) (size h.nz d.z)) in
  let error = Q.abs Exact.(q (Half_space.speed h (given ray)) - speed) in
  Q.leq error
    Exact.((power (-98) * terms) + (power (-52) * Q.abs speed) + power (-1060))

let of_bounds () =
  let b = Bounds.v (Point.v 0. 1. 2.) (Point.v 3. infinity 5.) in
  let cuts = Half_space.of_bounds b in
  Alcotest.(check int) "one end at infinity is left out" 5 (List.length cuts);
  let mem (q : Point.t) =
    List.for_all
      (fun h ->
        let v, _ = exact_terms h (Ray.v q (Vec.v 1. 0. 0.)) in
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

let show ((h, ray) : Half_space.t * Ray.t) =
  Half_space.show h ^ "\n" ^ Draw.show_ray ray

let both = Gen.pair half_space Draw.ray

let suite =
  ( "half-space",
    [
      Law.law ~count:5000 ~print:show "its terms along a ray are exact" both
        along_exactly;
      Law.law ~count:8000
        ~print:(fun (x, (t, k)) ->
          Printf.sprintf "%s\nt = %h, %g ulp off" (show x) t k)
        "a verdict that is sure is right for t within 8 ulp"
        Gen.(
          pair both
            (pair
               (oneof [ map Float.abs (Draw.small 9); Draw.wide (-8.) 8. ])
               (Draw.uniform (-8.) 8.)))
        verdict_is_right;
      Law.law ~count:8000 ~print:show
        "the depth of a point is right to double-double" both
        depth_is_exact_to_double_double;
      Law.law ~count:8000 ~print:show
        "the speed is right in twice the precision" both
        speed_is_exact_to_double_double;
      Law.example "those of a box hold what the box holds" of_bounds;
    ] )
