open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families
open QCheck2

let p = Point.v
let v = Vec.v
let form = Quadrics.form
let cone = form 1. 1. (-1.) Vec.zero 0.

(* {1 Rows of the catalogue} *)

let meets name ?clip shape ray expected () =
  match (Quadrics.kind.answer (Made.quadric ?clip shape) ray, expected) with
  | None, None -> ()
  | Some a, Some t when Float.abs (a.t -. t) <= 1e-13 *. t -> ()
  | found, _ ->
      Alcotest.failf "%s: expected %s, found %s" name
        (Option.fold ~none:"no hit" ~some:string_of_float expected)
        (Family.show_answer found)

let bounds a b = Bounds.v a b

let rows =
  let paraboloid = form 1. 1. 0. (v 0. 0. 0.5) 0. in
  let cylinder = form 1. 1. 0. Vec.zero (-1.) in
  let hyperboloid = form 1. 1. (-1.) Vec.zero (-1.) in
  let planes = form 1. 0. 0. Vec.zero (-1.) in
  let x = v 1. 0. 0. in
  let example ?clip name shape ray expected =
    Law.example name (meets name ?clip shape ray expected)
  in
  [
    example "Q1: a generator of a cone, up to rounding" cone
      (Ray.v (p 0. 0. 2.) (v (cos 1.) (sin 1.) 1.))
      (Some 8.2547808514653e16);
    example "Q3: almost along the axis of a paraboloid" paraboloid
      (Ray.v (p 0.5 0.25 9.) (v 1e-9 0. (-1.)))
      (Some 8.6874999913125);
    example "Q4: the same, by less than numbers can square" paraboloid
      (Ray.v (p 0.5 0.25 9.) (v 1e-170 0. (-1.)))
      (Some 8.6875);
    example "Q5: through the apex of a cone" cone
      (Ray.v (p (-5.) 0. 0.) x)
      (Some 5.);
    example "Q6: a line that lies in a cone" cone
      (Ray.v (p (-3.) 0. (-3.)) (v 1. 0. 1.))
      None;
    example "Q6: a line that lies in a hyperboloid" hyperboloid
      (Ray.v (p 1. 0. 0.) (v 0. 1. 1.))
      None;
    example "Q7: almost along a cylinder" cylinder
      (Ray.v (p 0.5 0. 0.) (v 1e-9 0. 1.))
      (Some 499999999.99999994);
    example "Q7: along a cylinder" cylinder
      (Ray.v (p 0.5 0. 0.) (v 0. 0. 1.))
      None;
    example "Q11: a pair of planes" planes (Ray.v (p (-3.) 0. 0.) x) (Some 2.);
    example "Q11: between a pair of planes" planes (Ray.v Point.origin x)
      (Some 1.);
    example "Q11: a double plane"
      (form 1. 0. 0. Vec.zero 0.)
      (Ray.v (p (-3.) 0. 0.) x)
      (Some 3.);
    example "Q11: a point"
      (form 1. 1. 1. Vec.zero 0.)
      (Ray.v (p (-3.) 0. 0.) x)
      (Some 3.);
    example "Q11: past a point"
      (form 1. 1. 1. Vec.zero 0.)
      (Ray.v (p (-3.) 1e-10 0.) x)
      None;
    example "Q11: a quadric without points"
      (form 1. 1. 1. Vec.zero 1.)
      (Ray.v (p (-3.) 0. 0.) x)
      None;
    example "Q12: a clip plane through the silhouette" cylinder
      ~clip:(bounds (p (-2.) 1. (-1.)) (p 2. 2. 1.))
      (Ray.v (p (-5.) 1. 0.) x)
      (Some 5.);
    example "Q12: a clip plane one ulp beyond the silhouette" cylinder
      ~clip:(bounds (p (-2.) (Float.succ 1.) (-1.)) (p 2. 2. 1.))
      (Ray.v (p (-5.) 1. 0.) x)
      None;
    example "Q13: the first root clipped" cylinder
      ~clip:(bounds (p 0. (-2.) (-1.)) (p 2. 2. 1.))
      (Ray.v (p (-5.) 0. 0.) x)
      (Some 6.);
    example "Q13: the second root clipped" cylinder
      ~clip:(bounds (p (-2.) (-2.) (-1.)) (p 0. 2. 1.))
      (Ray.v (p (-5.) 0. 0.) x)
      (Some 4.);
    example "Q13: both roots clipped" cylinder
      ~clip:(bounds (p (-0.5) (-2.) (-1.)) (p 0.5 2. 1.))
      (Ray.v (p (-5.) 0. 0.) x)
      None;
    example "Q14: a double root at the origin of the ray"
      (form 1. 0. 0. Vec.zero 0.)
      (Ray.v Point.origin x) None;
  ]

let apex_normal () =
  let s = Surface.quadric (Made.quadric cone) () in
  match Surface.nearest s (Ray.v (p (-5.) 0. 0.) (v 1. 0. 0.)) with
  | None -> Alcotest.fail "missed"
  | Some h ->
      let n = (h.normal :> Vec.t) in
      Alcotest.(check bool) "unit" true (Float.abs (Vec.norm n -. 1.) < 1e-15)

(* {1 Rejected} *)

let rejected =
  let reject name ?clip ?caps shape =
    Law.example (name ^ " is rejected") (fun () ->
        match Quadric.make ?clip ?caps shape with
        | Error why when why <> "" -> ()
        | _ -> Alcotest.failf "%s is accepted" name)
  in
  let matrix f = Quadric_shape.Matrix (Array.init 16 f) in
  let one = v 1. 1. 1. and o = Point.origin in
  let ball = Quadric_shape.Ellipsoid { center = o; radii = one } in
  let tube until radius = Quadric_shape.Cylinder { from = o; until; radius } in
  [
    reject "Q11: an asymmetric matrix" (matrix float_of_int);
    reject "Q11: a zero matrix" (matrix (fun _ -> 0.));
    reject "a constant" (matrix (fun i -> if i = 15 then 1. else 0.));
    reject "Q11: a matrix with a nan"
      (matrix (fun i -> if i = 5 then nan else 1.));
    reject "a matrix of 9 numbers" (Matrix (Array.make 9 1.));
    reject "a form of 16 numbers"
      (Form { a = Array.make 16 1.; b = one; c = 0. });
    reject "an asymmetric form"
      (Form { a = [| 1.; 2.; 0.; 0.; 1.; 0.; 0.; 0.; 1. |]; b = one; c = 0. });
    reject "a form with an infinity"
      (Form { a = Array.make 9 1.; b = one; c = infinity });
    reject "a plane without a normal"
      (Plane { normal = v 0. (-0.) 0.; offset = 1. });
    reject "a plane nowhere" (Plane { normal = one; offset = nan });
    reject "an ellipsoid without a radius"
      (Ellipsoid { center = o; radii = v 1. 0. 1. });
    reject "an ellipsoid with a negative radius"
      (Ellipsoid { center = o; radii = v 1. (-1.) 1. });
    reject "an ellipsoid beyond 2^400"
      (Ellipsoid { center = p 0. 0x1.8p400 0.; radii = one });
    reject "a cylinder without length" (tube o 1.);
    reject "a cylinder without radius" (tube (p 0. 1. 0.) 0.);
    reject "a cylinder of nan radius" (tube (p 0. 1. 0.) nan);
    reject "a cone without length" (Cone { apex = o; base = o; radius = 1. });
    reject "a paraboloid of infinite radius"
      (Paraboloid { apex = o; base = p 0. 1. 0.; radius = infinity });
    reject "caps on an ellipsoid" ~caps:true ball;
    reject "an empty clip box" ~clip:(bounds (p 1. 0. 0.) (p 0. 1. 1.)) ball;
    reject "a clip box of nan" ~clip:(bounds (p nan 0. 0.) (p 1. 1. 1.)) ball;
  ]

(* {1 Substitution} *)

(* The equation each named form stands for, as a user would write it, times
   something positive. *)
let equation (s : Quadric_shape.t) (q : Point.t) =
  let about (c : Point.t) (r : Vec.t) f =
    f ((q.x -. c.x) /. r.x) ((q.y -. c.y) /. r.y) ((q.z -. c.z) /. r.z)
  in
  let axial a b =
    let axis = Point.sub b a and y = Point.sub q a in
    let l2 = Vec.dot axis axis in
    let k = Vec.dot y axis /. l2 in
    (k, Vec.norm (Vec.sub y (Vec.scale k axis)))
  in
  match s with
  | Matrix m ->
      let x = [| q.x; q.y; q.z; 1. |] in
      let sum = ref 0. in
      Array.iteri (fun i e -> sum := !sum +. (e *. x.(i / 4) *. x.(i mod 4))) m;
      !sum
  | Form { a; b; c } ->
      let x = [| q.x; q.y; q.z |] in
      let sum = ref c in
      Array.iteri (fun i e -> sum := !sum +. (e *. x.(i / 3) *. x.(i mod 3))) a;
      !sum -. (2. *. ((b.x *. q.x) +. (b.y *. q.y) +. (b.z *. q.z)))
  | Plane { normal = n; offset } ->
      (n.x *. q.x) +. (n.y *. q.y) +. (n.z *. q.z) -. offset
  | Ellipsoid { center; radii } ->
      about center radii (fun x y z -> (x *. x) +. (y *. y) +. (z *. z) -. 1.)
  | Cylinder { from; until; radius } ->
      let _, r = axial from until in
      (r *. r) -. (radius *. radius)
  | Cone { apex; base; radius } ->
      let k, r = axial apex base in
      (r *. r) -. (k *. radius *. k *. radius)
  | Paraboloid { apex; base; radius } ->
      let k, r = axial apex base in
      (r *. r) -. (k *. radius *. radius)
  | Hyperbolic_paraboloid { center; radii } ->
      about center radii (fun x y z -> (x *. x) -. (y *. y) -. z)
  | Hyperboloid_one_sheet { center; radii } ->
      about center radii (fun x y z -> (x *. x) +. (y *. y) -. (z *. z) -. 1.)
  | Hyperboloid_two_sheets { center; radii } ->
      about center radii (fun x y z -> (x *. x) +. (y *. y) -. (z *. z) +. 1.)

let shape_and_point =
  let matrix =
    let open Gen in
    let n = Draw.uniform (-3.) 3. in
    let* e = array_size (return 16) n in
    return
      (Quadric_shape.Matrix
         (Array.init 16 (fun i ->
              e.((4 * Int.min (i / 4) (i mod 4)) + Int.max (i / 4) (i mod 4)))))
  and random_form =
    let open Gen in
    let n = Draw.uniform (-3.) 3. in
    let* x = n and* y = n and* z = n and* xy = n and* xz = n and* yz = n in
    let* b = Draw.vec n and* c = n in
    return (Quadrics.form ~xy ~xz ~yz x y z b c)
  in
  Gen.pair
    (Gen.oneof [ Quadrics.named; Quadrics.named; matrix; random_form ])
    (Draw.point (Draw.uniform (-12.) 12.))

(* The form is the equation: the same zeros, the same sign. *)
let means (shape, (q : Point.t)) =
  let f = Form.of_shape shape in
  let value = Q.to_float (Exact_quadric.value f (Exact.point q)) in
  let y = Vec.norm (Point.sub q (Form.center f)) in
  let size = (f.a_size *. y *. y) +. (2. *. f.g_size *. y) +. Float.abs f.k in
  Float.abs (value -. equation shape q) <= 0x1p-42 *. size

(* F is 0 within the error of the hit: by the gradient and the curvature. *)
let on_surface { Family.shape = s; ray } =
  match Surface.nearest (Surface.quadric s ()) ray with
  | None -> true
  | Some h when h.part > 0 ->
      let cut =
        List.find
          (fun (c : Exact_quadric.cut) -> c.cap = Some h.part)
          (Exact_quadric.of_quadric s).cuts
      in
      let off = Exact_quadric.beyond cut (Exact.point h.point) in
      let e = Exact.vec h.local.error in
      let n = Exact_quadric.normal cut in
      let n = Exact.(v (Q.abs n.x) (Q.abs n.y) (Q.abs n.z)) in
      Q.leq (Q.abs off) (Exact.dot n e)
  | Some h ->
      let f = Form.of_shape (Quadric.shape s) in
      let q = Exact.point h.point in
      let e = Exact.size (Exact.vec h.local.error) in
      let g = Exact.size (Exact_quadric.gradient f q) in
      let value = Exact_quadric.value f q in
      Q.leq (Q.abs value) Exact.(e * ((two * g) + (Exact.q f.a_size * e)))

let clipped { Family.shape = s; ray } =
  match (Surface.nearest (Surface.quadric s ()) ray, Quadric.clip s) with
  | None, _ -> true
  | Some h, clip ->
      let reach =
        0x1p-40
        *. (Vec.norm (Point.sub h.point Point.origin)
           +. Vec.norm (Point.sub ray.origin Point.origin))
      in
      let held b = Bounds.mem h.point (Bounds.widen reach b) in
      held (Quadric.bounds s) && Option.fold ~none:true ~some:held clip

(* The gradient points to where F > 0, so it is the side that decides. *)
let side_of_gradient { Family.shape = s; ray } =
  match Surface.nearest (Surface.quadric s ()) ray with
  | Some h when h.part = 0 -> (
      let f = Form.of_shape (Quadric.shape s) in
      let line = Crossing.line ray in
      let at = Exact.along line.origin line.direction (Exact.q h.t) in
      let g = Exact_quadric.gradient f at in
      let slope = Exact.dot g line.direction in
      (* Where the gradient vanishes, or is across the ray, t's rounding
         decides. *)
      let way = Exact.(size line.origin + (q h.t * size line.direction)) in
      let terms = Exact.((q f.a_size * way) + q f.g_size) in
      Q.leq (Q.abs slope) Exact.(power (-24) * terms * size line.direction)
      ||
      match h.side with
      | Outside -> Q.sign slope < 0
      | Inside -> Q.sign slope > 0)
  | _ -> true

let families name holds =
  List.map
    (fun { Family.name = family; cases } ->
      Law.law ~count:1500
        ~print:(Family.show Quadrics.kind)
        (name ^ ": " ^ family)
        cases holds)
    Quadrics.[ k1; k7; simply; from_far; capped; clipped ]

let uv_of_plane () =
  let check normal (q : Point.t) expected =
    let s = Made.quadric (Plane { normal; offset = 0. }) in
    let ray = Ray.v (Draw.move q normal 2.) (Vec.neg normal) in
    match Surface.nearest (Surface.quadric s ()) ray with
    | None -> Alcotest.fail "missed"
    | Some h ->
        Alcotest.(check (option (pair (float 1e-12) (float 1e-12))))
          "uv" (Some expected) (Lazy.force h.local.uv)
  in
  check (v 0. 1. 0.) (p 3. 0. 5.) (3., 5.);
  check (v (-2.) 1. 0.) (p 0. 0. 5.) (0., 5.);
  check (v 0. 0. 1.) (p 3. 4. 0.) (3., 4.)

let uv_of_cylinder () =
  let s =
    Made.quadric ~caps:true
      (Cylinder { from = p 0. 1. 0.; until = p 0. 3. 0.; radius = 1. })
  in
  let uv ray =
    match Surface.nearest (Surface.quadric s ()) ray with
    | None -> Alcotest.fail "missed"
    | Some h -> Option.get (Lazy.force h.local.uv)
  in
  let _, v' = uv (Ray.v (p 5. 1.5 0.) (v (-1.) 0. 0.)) in
  Alcotest.(check (float 1e-12)) "along the axis" 0.25 v';
  let _, top = uv (Ray.v (p 0.5 9. 0.) (v 0. (-1.) 0.)) in
  Alcotest.(check (float 1e-12)) "the cap at the second end" 1. top;
  let turns =
    List.init 8 (fun i ->
        let a = Float.pi *. float_of_int i /. 4. in
        fst
          (uv
             (Ray.v
                (p (5. *. cos a) 2. (5. *. sin a))
                (v (-.cos a) 0. (-.sin a)))))
  in
  List.iteri
    (fun i u ->
      Alcotest.(check bool) "in 0..1" true (u >= 0. && u < 1.);
      let next = List.nth turns ((i + 1) mod 8) in
      let step = Float.abs (next -. u) in
      Alcotest.(check bool)
        "an eighth" true
        (Float.abs (step -. 0.125) < 1e-12 || Float.abs (step -. 0.875) < 1e-12))
    turns

let suite =
  ( "quadric",
    List.concat
      [
        rows;
        [
          Law.example "Q5: the apex has a normal" apex_normal;
          Law.law ~count:8000
            ~print:(fun (s, q) ->
              Quadrics.show_shape s ^ " at " ^ Draw.show_point q)
            "a form means the equation it stands for" shape_and_point means;
          Law.example "a plane's uv are the other coordinates" uv_of_plane;
          Law.example "a cylinder's uv are turn and height" uv_of_cylinder;
        ];
        families "points are on the surface within their error" on_surface;
        families "points are within bounds and clip" clipped;
        families "the side is that of the gradient" side_of_gradient;
        rejected;
      ] )
