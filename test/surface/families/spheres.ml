(** Families for spheres: F1 to F9 of the numerical notes, and some more. *)

open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2.Gen
open Draw
open Made

let show (s : Sphere.t) =
  Printf.sprintf "sphere (%h %h %h) of radius %h" s.x s.y s.z s.radius

let kind =
  {
    Family.show;
    answer = (fun s -> answer (Surface.sphere s ()));
    truth = Exact_sphere.truth_along;
  }

let family name cases = { Family.name; cases }
let case shape ray = { Family.shape; ray }
let unit_sphere = sphere Point.origin 1.

(* A ray that passes the unit sphere's centre at [miss]. *)
let past ~distance ~miss =
  let* d = unit in
  let* side = across d and* distance = distance and* miss = miss in
  return (move (move Point.origin d (-.distance)) side miss, d)

let f1 =
  let walls =
    List.map
      (fun (x, y, z) -> sphere (p x y z) 1e5)
      [
        (1e5 +. 1., 40.8, 81.6);
        (-1e5 +. 99., 40.8, 81.6);
        (50., 40.8, 1e5);
        (50., 40.8, -1e5 +. 170.);
        (50., 1e5, 81.6);
        (50., -1e5 +. 81.6, 81.6);
      ]
  in
  family "F1 smallpt's walls, from in the room"
    (let* x = uniform 1. 99. and* y = uniform 0. 81.6 in
     let* z = uniform 0. 170. and* d = unit and* wall = pick walls in
     return (case wall (Ray.v (p x y z) d)))

let f2 =
  family "F2 a unit sphere from up to 1e9 away"
    (let* o, d = past ~distance:(wide 0.3 9.) ~miss:(uniform 0. 1.2) in
     return (case unit_sphere (Ray.v o d)))

let near_one lo hi = map2 (fun s e -> 1. +. (s *. e)) sign (wide lo hi)

let f3 =
  family "F3 grazing a unit sphere within 1e-3..1e-15"
    (let* o, d = past ~distance:(wide 0. 4.) ~miss:(near_one (-15.) (-3.)) in
     return (case unit_sphere (Ray.v o d)))

let f4 =
  let size = signed (wide (-8.) 8.) in
  family "F4 sizes and places over 1e-8..1e8"
    (let* c = point size and* r = wide (-8.) 8. and* o = point size in
     let* a = vec (uniform (-1.2) 1.2) in
     return (case (sphere c r) (Ray.v o (toward o (move c a r)))))

let f5 =
  family "F5 from a rounded point of the sphere, inwards"
    (let* c = point (uniform (-1e3) 1e3) and* r = wide (-3.) 6. in
     let* n = unit and* d = unit in
     let d = if Vec.dot d n > 0. then Vec.neg d else d in
     return (case (sphere c r) (Ray.v (move c n r) d)))

let f6 =
  family "F6 directions of length 1e-170..1e170"
    (let* o, d = past ~distance:(wide 0.3 3.) ~miss:(uniform 0. 1.2) in
     let* k = oneof [ wide (-170.) (-100.); wide 100. 170. ] in
     return (case unit_sphere (Ray.v o (Vec.scale k d))))

let f7 =
  family "F7 directions of length 1e-4..1e4"
    (let* o, d = past ~distance:(wide 0.3 3.) ~miss:(uniform 0. 1.2) in
     let* k = wide (-4.) 4. in
     return (case unit_sphere (Ray.v o (Vec.scale k d))))

let f8 =
  family "F8 from 1e6..1e18 away, off the origin"
    (let* c = point (uniform (-1e3) 1e3) and* far = wide 6. 18. in
     let* n = unit and* m = unit and* miss = uniform 0. 1.2 in
     let o = move c n far in
     return
       (case (sphere c 1.) (Ray.v o (normalised (toward o (move c m miss))))))

let f9 =
  family "F9 a scene at 1e9"
    (let* a = vec (uniform (-1e3) 1e3) and* r = wide (-3.) 3. in
     let c = Point.add (p 1e9 0. (-1e9)) a in
     let* n = unit and* m = unit in
     let* far = wide (-1.) 0.5 and* miss = uniform 0. 1.1 in
     let o = move c n (r *. far) in
     return (case (sphere c r) (Ray.v o (toward o (move c m (r *. miss))))))

let snapped =
  family "whole numbers: exact tangents, origins on the sphere"
    (let* c = point (small 3)
     and* r = map (fun x -> 1. +. Float.abs x) (small 4) in
     let* o = point (small 8) and* d = vec (small 4) in
     let d = if Vec.largest d = 0. then Vec.v 0. 1. 0. else d in
     return (case (sphere c r) (Ray.v o d)))

(* Circles through whole points: 3² + 4² = 5², 2² + 3² + 6² = 7² and so on. *)
let tangent =
  let corners =
    [ (3., 4., 0., 5.); (2., 3., 6., 7.); (1., 2., 2., 3.); (1., 4., 8., 9.) ]
  in
  family "exact tangents, moved by an ulp or not at all"
    (let* x, y, z, r = pick corners in
     let* k = power (-20) 20 and* far = small 9 and* far' = small 9 in
     let n = v x y z in
     let t1 = v y (-.x) 0. in
     let t2 = Vec.cross n t1 in
     let d = Vec.add (Vec.scale (far +. 10.) t1) (Vec.scale far' t2) in
     let* s = sign in
     let d = Vec.scale (s *. k) d in
     let from = move (Point.add Point.origin (Vec.scale k n)) d (-1.) in
     let* ox = nudged (return from.x) and* oy = nudged (return from.y) in
     let* r = nudged (return (k *. r)) in
     return (case (sphere Point.origin r) (Ray.v (p ox oy from.z) d)))

let central =
  family "from at and near the centre"
    (let* c = point any_coordinate and* r = wide (-6.) 6. in
     let* n = unit and* k = oneof [ return 0.; wide (-20.) 0. ] in
     let* d = unit >>= stretched in
     return (case (sphere c r) (Ray.v (move c n (k *. r)) d)))

let anything =
  family "anything at all, subnormals too"
    (let* c = point any_coordinate
     and* r = oneof [ wide (-8.) 8.; power (-30) 30 ] in
     let* n = unit
     and* k = oneof [ return 1.; uniform 0. 1.2; near_one (-16.) (-1.) ] in
     let* ray = ray_at (move c n (k *. r)) in
     return (case (sphere c r) ray))

let extreme =
  family "coordinates and radii up to 2^400 and down to 2^-400"
    (let* e = int_range (-400) 400 in
     let* e' = int_range (Int.max (-400) (e - 60)) (Int.min 400 (e + 60)) in
     let at k x = Float.ldexp x (k - 4) in
     let* c = point (map (at e) (uniform (-1.) 1.)) in
     let* o = point (map (at e') (uniform (-1.) 1.)) in
     let* r = map (fun x -> Float.max 0x1p-400 (at e x)) (uniform 0.01 1.) in
     let* n = unit and* miss = uniform 0. 1.1 in
     return (case (sphere c r) (Ray.v o (toward o (move c n (r *. miss))))))

let all =
  [
    f1;
    f2;
    f3;
    f4;
    f5;
    f6;
    f7;
    f8;
    f9;
    snapped;
    tangent;
    central;
    anything;
    extreme;
  ]
