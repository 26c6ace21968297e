open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families
open QCheck2

let p = Point.v
let v = Vec.v

(* {1 What is visited} *)

(* Every item whose closed box the ray meets, in exact arithmetic. *)
let meets_box (b : Bounds.t) ray =
  let line = Crossing.line ray in
  let slab lo hi o d =
    let lo = Exact.q lo and hi = Exact.q hi in
    if Q.sign d = 0 then
      if Q.leq lo o && Q.leq o hi then Some (Q.minus_inf, Q.inf) else None
    else
      let a = Q.div (Q.sub lo o) d and b = Q.div (Q.sub hi o) d in
      Some (Q.min a b, Q.max a b)
  in
  let { Crossing.origin = o; direction = d } = line in
  match
    (slab b.x0 b.x1 o.x d.x, slab b.y0 b.y1 o.y d.y, slab b.z0 b.z1 o.z d.z)
  with
  | Some (a, a'), Some (b, b'), Some (c, c') ->
      let near = Q.max a (Q.max b c) and far = Q.min a' (Q.min b' c') in
      Q.leq (Q.max Q.zero near) far
  | _ -> false

let probe (r : Ray.t) = Bvh.probe (Object_ray.v r.origin r.direction)

let visited boxes (ray : Ray.t) =
  let h = Bvh.make ~bounds:Fun.id boxes in
  let seen = Array.make (Array.length boxes) 0 in
  let test () i b =
    if not (Bounds.equal b boxes.(i)) then Law.fail "item %d is another" i;
    seen.(i) <- seen.(i) + 1;
    false
  in
  let stopped = Bvh.visit h (probe ray) (Cursor.v infinity) () test in
  (seen, stopped)

let show (boxes, ray) =
  String.concat "\n" (Array.to_list (Array.map Bounds.show boxes))
  ^ "\n" ^ Draw.show_ray ray

let boxes_and_ray =
  let open Gen in
  let corner =
    oneof
      [
        Draw.point (Draw.small 4);
        Draw.point (Draw.uniform (-9.) 9.);
        Draw.point Draw.any_coordinate;
      ]
  in
  let box =
    let* a = corner and* b = corner in
    return (Bounds.of_points [ a; b ])
  in
  let* boxes = array_size (int_range 1 30) box in
  let* k = int_bound (Array.length boxes - 1) in
  let b = boxes.(k) in
  let on lo hi =
    oneof [ return lo; return hi; return ((lo *. 0.5) +. (hi *. 0.5)) ]
  in
  let* x = on b.x0 b.x1 and* y = on b.y0 b.y1 and* z = on b.z0 b.z1 in
  let target = p x y z in
  let* ray =
    oneof
      [
        Draw.ray_at target;
        (let* d = Draw.axial and* far = Draw.small 9 in
         return (Ray.v (Draw.move target d far) d));
      ]
  in
  return (boxes, ray)

let none_left_out (boxes, ray) =
  let seen, stopped = visited boxes ray in
  (not stopped)
  && Array.for_all Fun.id
       (Array.mapi
          (fun i b ->
            seen.(i) <= 1
            && (seen.(i) = 1
               || (not (meets_box b ray))
               || Law.fail "item %d is left out: %s" i (Bounds.show b)))
          boxes)

(* Rounding included: a box that a ray meets alone is met among others, whatever
   boxes are around it and whether those are met or passed through. *)
let met_as_alone (boxes, ray) =
  let seen, _ = visited boxes ray in
  let alone b = (fst (visited [| b |] ray)).(0) in
  Array.for_all2 (fun n b -> n >= alone b) seen boxes

let stops_at_first (boxes, (ray : Ray.t)) =
  let h = Bvh.make ~bounds:Fun.id boxes in
  let count = ref 0 in
  let stopped =
    Bvh.visit h (probe ray) (Cursor.v infinity) () (fun () _ _ ->
        incr count;
        true)
  in
  stopped = (!count > 0) && !count <= 1

let same_tree (boxes, (ray : Ray.t)) =
  let order () =
    let h = Bvh.make ~bounds:Fun.id boxes in
    let seen = ref [] in
    ignore
      (Bvh.visit h (probe ray) (Cursor.v infinity) () (fun () i _ ->
           seen := i :: !seen;
           false)
        : bool);
    !seen
  in
  List.equal Int.equal (order ()) (order ())

let holds_all (boxes, _) =
  let whole = Bvh.bounds (Bvh.make ~bounds:Fun.id boxes) in
  Array.for_all
    (fun (b : Bounds.t) -> Bounds.equal (Bounds.join whole b) whole)
    boxes

let far_boxes_are_passed_over () =
  let at i =
    Bounds.v (p 0. 0. (float_of_int i)) (p 1. 1. (float_of_int i +. 0.5))
  in
  let boxes = Array.init 1000 at in
  let h = Bvh.make ~bounds:Fun.id boxes in
  let cursor = Cursor.v infinity in
  let count = ref 0 in
  let stopped =
    let ray = Object_ray.v (p 0.5 0.5 (-1.)) (v 0. 0. 1.) in
    let here = Contact.v ~part:0 Outside in
    Bvh.visit h (Bvh.probe ray) cursor () (fun () i _ ->
        incr count;
        ignore (Cursor.take cursor (float_of_int (i + 1)) here : Contact.t);
        false)
  in
  Alcotest.(check bool) "not stopped" false stopped;
  Alcotest.(check bool)
    (Printf.sprintf "few items tested: %d" !count)
    true (!count <= 8)

(* {1 Hard arrangements} *)

let timed name limit f =
  let start = Sys.time () in
  let x = f () in
  let seconds = Sys.time () -. start in
  if seconds > limit then Alcotest.failf "%s took %.2f s" name seconds;
  x

let spheres n at =
  let rand = Random.State.make [| 1 |] in
  let number () = Random.State.float rand 2. -. 1. in
  Array.init n (fun i ->
      let c, r = at i number in
      Surface.sphere (Made.sphere c r) i)

(* Generous limits: they are for seeing squares, not seconds. *)
let hundred_thousand () =
  let n = 100_000 in
  let all =
    spheres n (fun _ x ->
        let a = x () in
        let b = x () in
        (p a b (x ()), 0.002))
  in
  let g = timed "the build" 5. (fun () -> Surface.group all) in
  let nearest ray =
    Option.map
      (fun (h : int Hit.t) -> (h.material, h.t))
      (Surface.nearest g ray)
  in
  let scan ray =
    Array.fold_left
      (fun best s ->
        match (best, Surface.nearest s ray) with
        | Some (_, t), Some (h : int Hit.t) when t <= h.t -> best
        | best, None -> best
        | _, Some h -> Some (h.material, h.t))
      None all
  in
  let rand = Random.State.make [| 2 |] in
  for _ = 1 to 5 do
    let x () = Random.State.float rand 2. -. 1. in
    let a = x () in
    let ray = Ray.v (p a (x ()) (-3.)) (v 0.01 0.02 1.) in
    Alcotest.(check (option (pair int (float 0.))))
      "as the linear scan" (scan ray) (nearest ray)
  done

let all_in_one_place () =
  let n = 100_000 in
  let all = spheres n (fun i _ -> (p 1. 2. 3., 1. +. float_of_int (i mod 7))) in
  let g = timed "the build" 5. (fun () -> Surface.group all) in
  match Surface.nearest g (Ray.v (p (-20.) 2. 3.) (v 1. 0. 0.)) with
  | Some h ->
      Alcotest.(check (float 0.)) "the largest" 14. h.t;
      Alcotest.(check (list int)) "of the least place" [ 6 ] h.path
  | None -> Alcotest.fail "missed"

let all_the_same () =
  let g = Surface.group (spheres 1000 (fun _ _ -> (p 1. 2. 3., 1.))) in
  match Surface.nearest g (Ray.v (p (-20.) 2. 3.) (v 1. 0. 0.)) with
  | Some h -> Alcotest.(check (list int)) "the least place" [ 0 ] h.path
  | None -> Alcotest.fail "missed"

(* Sizes that halve along a line: the worst case for halving space. *)
let dwindling () =
  let all =
    spheres 790 (fun i _ ->
        let s = Float.ldexp 1. (-i / 2) in
        (p s 0. 0., s /. 8.))
  in
  let g = timed "the build" 2. (fun () -> Surface.group all) in
  match Surface.nearest g (Ray.v (p 9. 0. 0.) (v (-1.) 0. 0.)) with
  | Some h -> Alcotest.(check (list int)) "the largest" [ 0 ] h.path
  | None -> Alcotest.fail "missed"

let unbounded () =
  let plane y =
    Surface.quadric (Made.quadric (Plane { normal = v 0. 1. 0.; offset = y })) 1
  in
  let s = Surface.sphere (Made.sphere (p 0. 5. 0.) 1.) 0 in
  let g = Surface.group [| s; plane 0.; plane 1. |] in
  let first direction =
    Option.map
      (fun (h : int Hit.t) -> h.path)
      (Surface.nearest g (Ray.v (p 0. 9. 0.) direction))
  in
  Alcotest.(check (option (list int)))
    "down" (Some [ 0 ])
    (first (v 0. (-1.) 0.));
  Alcotest.(check (option (list int)))
    "past the sphere" (Some [ 2 ])
    (first (v 5. (-1.) 0.));
  Alcotest.(check (option (list int))) "up" None (first (v 0. 1. 0.));
  Alcotest.(check bool)
    "no finite bounds" false
    (Bounds.is_finite (Surface.bounds g))

let law ?count name holds = Law.law ?count ~print:show name boxes_and_ray holds

let suite =
  ( "bounding volume hierarchy",
    [
      law ~count:5000
        "no item whose box the ray meets is left out, none is visited twice"
        none_left_out;
      law ~count:5000 "a box that is met alone is met among others" met_as_alone;
      law "a test that says so ends the visit" stops_at_first;
      law "the same boxes make the same tree" same_tree;
      law "its bounds hold every item" holds_all;
      Law.example "boxes beyond the cursor are passed over"
        far_boxes_are_passed_over;
      Law.example "100,000 spheres are built in no time and met as by a scan"
        hundred_thousand;
      Law.example
        "G5: 100,000 spheres about one point are built, ties to the lowest"
        all_in_one_place;
      Law.example "G5: 1,000 identical spheres tie to the lowest place"
        all_the_same;
      Law.example "G5: spheres that dwindle by 2^400 are built and met"
        dwindling;
      Law.example "planes and spheres live in one group" unbounded;
    ] )
