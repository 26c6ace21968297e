open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families
open QCheck2

(* {1 Displacement} *)

let rounded_once (velocity, time) =
  let m = Motion.v ~velocity ~shutter:(0., 1.) in
  let d = Motion.displacement m time in
  List.for_all
    (fun axis ->
      let exact = Exact.(Q.mul (q time) (q (Vec.get velocity axis))) in
      Exact.within 0.5 (Vec.get d axis) exact)
    [ 0; 1; 2 ]

(* What has moved by d sees a ray as if that had moved by -d, exactly. *)
let followed ((ray : Ray.t), d) =
  let r = Motion.follow d (Object_ray.of_ray ray) in
  let exact hi lo moved axis =
    let get a = Exact.q (Vec.get a axis) in
    Q.equal (Q.add (get hi) (get lo)) moved
  in
  let from axis =
    let get a = Exact.q (Vec.get a axis) in
    Q.sub (get (Point.sub ray.origin Point.origin)) (get d)
  and along axis = Exact.q (Vec.get ray.direction axis) in
  List.for_all
    (fun axis ->
      exact (Point.sub r.origin Point.origin) r.origin_low (from axis) axis
      && exact r.direction r.direction_low (along axis) axis)
    [ 0; 1; 2 ]

(* {1 Bounds} *)

let bounds_hold ((m : Moved.t), times) =
  let b = Surface.bounds (Moved.moving m (Shapes.surface 0 m.case.shape))
  and still = Surface.bounds (Shapes.surface 0 m.case.shape) in
  let open Exact in
  let inside lo hi low high by =
    (* An end may be infinite; then so is its bound. *)
    let below a b = a = neg_infinity || Q.leq (q a) b
    and above a b = a = infinity || Q.geq (q a) b in
    (if Float.is_finite low then below lo (Q.add (q low) (q by)) else lo = low)
    &&
    if Float.is_finite high then above hi (Q.add (q high) (q by)) else hi = high
  in
  List.for_all
    (fun time ->
      let d = Vec.scale time m.velocity in
      inside b.x0 b.x1 still.x0 still.x1 d.x
      && inside b.y0 b.y1 still.y0 still.y1 d.y
      && inside b.z0 b.z1 still.z0 still.z1 d.z
      || Law.fail "at %h it leaves %s" time (Bounds.show b))
    times

let bounds_of_still () =
  let s = Shapes.surface 0 (Sphere Spheres.unit_sphere) in
  let check what velocity shutter expected =
    Alcotest.(check bool)
      what true
      (Bounds.equal expected
         (Surface.bounds (Surface.moving ~velocity ~shutter s)))
  in
  let b = Surface.bounds s in
  check "without velocity" Vec.zero (-1., 5.) b;
  check "without time" (Vec.v 1. 2. 3.) (0., 0.) b;
  check "along x, backwards as well" (Vec.v 2. 0. 0.) (-1., 5.)
    { b with x0 = Float.pred (b.x0 -. 2.); x1 = Float.succ (b.x1 +. 10.) };
  let nobody : unit Surface.t = Surface.group [||] in
  let b =
    Surface.bounds
      (Surface.moving ~velocity:(Vec.v 1. 1. 1.) ~shutter:(0., 1.) nobody)
  in
  Alcotest.(check bool) "of nothing" true (b.x0 > b.x1)

let suite =
  ( "motion",
    [
      Law.law
        ~print:(fun (v, time) ->
          Printf.sprintf "%s at %h" (Draw.show_vec v) time)
        "the displacement is time times velocity, rounded once"
        Gen.(pair Moved.velocity (Moved.within (-3., 3.)))
        rounded_once;
      Law.law
        ~print:(fun (ray, d) -> Draw.show_ray ray ^ " by " ^ Draw.show_vec d)
        "a ray is followed exactly"
        (Gen.pair Moved.ray Moved.velocity)
        followed;
      Law.example "the bounds of what does not move are as they were"
        bounds_of_still;
      Law.law
        ~print:(fun (m, _) -> Moved.show m)
        "the bounds hold the surface while the shutter is open" Moved.at_times
        bounds_hold;
    ] )
