(** Families for boxes. *)

open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2.Gen
open Draw
open Made

let show (b : Box.t) =
  let b = (b :> Bounds.t) in
  Printf.sprintf "box %s to %s"
    (show_point (Bounds.low b))
    (show_point (Bounds.high b))

let kind =
  {
    Family.show;
    answer = (fun b -> answer (Surface.box b ()));
    truth = Exact_box.truth_along;
  }

let family name cases = { Family.name; cases }
let case shape ray = { Family.shape; ray }

(* The box between two corners in any order, made thick on all axes but one. *)
let between (a : Point.t) (b : Point.t) ~flat =
  let sort u v = (Float.min u v, Float.max u v) in
  let end_ axis u v =
    let lo, hi = sort u v in
    if axis = flat then (lo, lo)
    else if lo < hi then (lo, hi)
    else (lo, lo +. (2. *. Float.max 1. (Float.abs lo)))
  in
  let x0, x1 = end_ 0 a.x b.x
  and y0, y1 = end_ 1 a.y b.y
  and z0, z1 = end_ 2 a.z b.z in
  box (p x0 y0 z0) (p x1 y1 z1)

let box_of corner =
  let* a = corner and* b = corner in
  let* flat = either 15 (int_bound 2) (return 3) in
  return (between a b ~flat)

(* On a face, an edge or a corner, or anywhere within. *)
let point_of (b : Box.t) =
  let b = (b :> Bounds.t) in
  let on lo hi =
    oneof
      [
        return lo;
        return hi;
        map (fun k -> lo +. (k *. (hi -. lo))) (uniform 0. 1.);
      ]
  in
  let* x = on b.x0 b.x1 and* y = on b.y0 b.y1 and* z = on b.z0 b.z1 in
  return (p x y z)

let aimed =
  family "aimed at faces, edges and corners"
    (let* c = unit and* far = wide 0. 4. and* s = wide (-3.) 3. in
     let c = move Point.origin c far in
     let* a = vec (uniform 0. 1.) and* b = vec (uniform 0. 1.) in
     let shape = between (move c a (-.s)) (move c b s) ~flat:3 in
     let* target = point_of shape in
     let* d = unit and* far = wide 0. 5. in
     let o = move c d far in
     return (case shape (Ray.v o (toward o target))))

let plain =
  family "ordinary boxes, met anywhere and missed"
    (let* a = point (uniform (-3.) 3.) and* b = point (uniform (-3.) 3.) in
     let* o = point (uniform (-9.) 9.) and* target = point (uniform (-3.) 3.) in
     return (case (between a b ~flat:3) (Ray.v o (toward o target))))

let whole =
  family "whole numbers: ties at edges, origins in faces"
    (let* shape = box_of (point (small 4)) in
     let* o = point (small 6) in
     let* d = oneof [ vec (small 4); axial ] in
     let d = if Vec.largest d = 0. then Vec.v 0. (-0.) 1. else d in
     return (case shape (Ray.v o d)))

let through =
  family "through exact points of faces, edges and corners"
    (let* shape = box_of (point (map (fun x -> x /. 4.) (small 40))) in
     let* target = point_of shape in
     let* d = oneof [ vec (small 9); axial ] in
     let d = if Vec.largest d = 0. then Vec.v 1. (-0.) 0. else d in
     let* k = oneof [ small 9; map (Float.ldexp 1.) (int_range (-9) 9) ] in
     return (case shape (Ray.v (move target d k) d)))

let parallel =
  family "along the faces"
    (let* shape = box_of (point any_coordinate) in
     let* target = point_of shape in
     let* d = axial and* k = oneof [ small 9; any_coordinate ] in
     let o = move target d (-.k) in
     let* x = nudged (return o.x) and* y = nudged (return o.y) in
     return (case shape (Ray.v (p x y o.z) d)))

let slanted =
  family "almost along the faces, some directions subnormal"
    (let* shape = box_of (point (small 4)) in
     let* target = point_of shape in
     let* d = axial in
     let tilt =
       oneof
         [
           return 0.;
           pick [ 5e-324; -5e-324; 1e-310; -1e-310 ];
           signed (wide (-25.) (-1.));
         ]
     in
     let* e = vec tilt and* k = small 9 in
     return (case shape (Ray.v (move target d k) (Vec.add d e))))

let anything =
  family "anything at all, subnormals too"
    (let* shape = box_of (point any_coordinate) in
     let* target = point_of shape in
     let* ray = ray_at target in
     return (case shape ray))

let scaled =
  family "directions of length 1e-300..1e300"
    (let* shape = box_of (point (uniform (-3.) 3.)) in
     let* target = point_of shape and* o = point (uniform (-9.) 9.) in
     let* k = wide (-300.) 300. in
     return (case shape (Ray.v o (Vec.scale k (toward o target)))))

let all = [ plain; aimed; whole; through; parallel; slanted; anything; scaled ]
