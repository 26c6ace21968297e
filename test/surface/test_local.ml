open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families
open QCheck2

let p = Point.v
let v = Vec.v

(* {1 A surface and what it says of the point that a ray meets} *)

let located (s : Shapes.t) ({ origin; direction; _ } : Ray.t) =
  let cursor = Cursor.v infinity in
  let ray = Object_ray.v origin direction in
  let ask meet locate =
    let contact = meet ray Contact.none cursor in
    if Contact.is_none contact then None
    else Some (locate ray cursor.t contact, contact)
  in
  match s with
  | Sphere s -> ask (Sphere.meet s) (Sphere.locate s)
  | Box b -> ask (Box.meet b) (Box.locate b)
  | Triangle s -> ask (Triangle.meet s) (fun ray _ _ -> Triangle.locate s ray)
  | Quadric q -> ask (Quadric.meet q) (Quadric.locate q)

let found f { Family.shape; ray } =
  match located shape ray with
  | None -> true
  | Some (local, contact) -> f shape (local : Local.t) (Contact.part contact)

let must s ray =
  match located s ray with
  | Some (local, _) -> local
  | None -> Alcotest.fail "missed"

(* {1 What all of them promise} *)

let unit (d : Dir.t) =
  let a = Exact.vec (d :> Vec.t) in
  Q.leq (Q.abs Exact.(dot a a - one)) Exact.(power (-50) + power (-100))

let is_sound _ (l : Local.t) _ =
  let check what holds = holds || Law.fail "%s" what in
  let e = l.error in
  check "the point is not finite" (Point.is_finite l.point)
  && check "the normal is not unit" (unit l.normal)
  && check "the error is negative or not finite"
       (Vec.is_finite e && e.x >= 0. && e.y >= 0. && e.z >= 0.)
  && check "the shading normal is no one's" (Option.is_none l.smooth)

let is_flat (s : Shapes.t) (l : Local.t) part =
  let expected =
    match s with
    | Sphere _ -> false
    | Box _ | Triangle _ -> true
    | Quadric q -> part > 0 || Form.is_linear (Form.of_shape (Quadric.shape q))
  in
  l.flat = expected

let has_uv (s : Shapes.t) (l : Local.t) _ =
  let expected =
    match s with
    | Sphere _ | Box _ | Triangle _ -> true
    | Quadric q -> (
        match Quadric.shape q with
        | Plane _ | Cylinder _ | Cone _ | Paraboloid _ -> true
        | _ -> false)
  in
  match Lazy.force l.uv with
  | Some (u, v) -> expected && Float.is_finite u && Float.is_finite v
  | None -> not expected

let close a b = Float.abs (a -. b) <= 0x1p-40

(* The outward side: along the gradient, away from the centre, the side on
   which corners run counter-clockwise. *)
let faces_outside (s : Shapes.t) (l : Local.t) part =
  let n = (l.normal :> Vec.t) in
  let along (a : Exact.vec) =
    Q.sign (Exact.size a) = 0
    ||
    let n = Exact.vec n in
    let c = Exact.dot a n in
    (* The cosine is 1 but for rounding. *)
    Q.sign c > 0
    && Q.leq Exact.((dot a a * dot n n) - (c * c)) Exact.(power (-60) * dot a a)
  in
  match s with
  | Sphere s ->
      let c = Exact.point (Sphere.center s) in
      (* From far away the point is rounded, and not the normal. *)
      let away = Exact.(sub (point l.point) c) in
      Q.sign (Exact.dot away (Exact.vec n)) > 0
  | Box _ ->
      let k = if part land 1 = 1 then 1. else -1. in
      Vec.get n (part / 2) = k
  | Triangle s -> along (Exact_triangle.normal s)
  | Quadric q when part = 0 ->
      let f = Form.of_shape (Quadric.shape q) in
      let g = Exact_quadric.gradient f (Exact.point l.point) in
      let fuzzy =
        Exact.(
          Q.leq (size g)
            (power (-20)
            * ((q f.a_size * size (Exact_quadric.offset f (point l.point)))
              + q f.g_size)))
      in
      fuzzy || along g
  | Quadric q -> (
      match Quadric_shape.ends (Quadric.shape q) with
      | None -> false
      | Some { first; second; _ } ->
          let axis = Exact.(sub (point second) (point first)) in
          along (if part = 1 then axis else Exact.(scale (Q.neg one) axis)))

(* {1 uv} *)

let uv (l : Local.t) = Option.get (Lazy.force l.uv)

let check_uv name (u, v) l =
  Alcotest.(check (pair (float 1e-12) (float 1e-12))) name (u, v) (uv l)

let inwards d = Ray.v (Draw.move Point.origin d 9.) (Vec.neg d)

let uv_of_sphere () =
  let s = Shapes.Sphere (Made.sphere Point.origin 2.) in
  let at d = must s (inwards d) in
  check_uv "the middle looks along z" (0.5, 0.5) (at (v 0. 0. 1.));
  check_uv "u runs to the right" (0.75, 0.5) (at (v 1. 0. 0.));
  check_uv "and is less on the left" (0.25, 0.5) (at (v (-1.) 0. 0.));
  check_uv "an eighth" (0.625, 0.5) (at (v 1. 0. 1.));
  check_uv "v runs up" (0.5, 0.75) (at (v 0. 1. 1.));
  check_uv "and down" (0.5, 0.25) (at (v 0. (-1.) 1.));
  let _, top = uv (at (v 0. 1. 0.)) and _, bottom = uv (at (v 0. (-1.) 0.)) in
  Alcotest.(check (float 1e-12)) "the top" 1. top;
  Alcotest.(check (float 1e-12)) "the bottom" 0. bottom;
  let back, _ = uv (at (v 0. 0. (-1.))) in
  Alcotest.(check bool) "the seam is behind" true (back = 0. || back = 1.)

let sphere_uv { Family.shape; ray } =
  found
    (fun _ l _ ->
      let n = (l.normal :> Vec.t) and u, v = uv l in
      u = 0.5 +. (Float.atan2 n.x n.z /. (2. *. Float.pi))
      && close (sin (Float.pi *. (v -. 0.5))) n.y
      && 0. <= u && u <= 1. && 0. <= v && v <= 1.)
    { Family.shape = Shapes.Sphere shape; ray }

let uv_of_box () =
  let s = Shapes.Box (Made.box (p 0. 0. 0.) (p 2. 4. 8.)) in
  let q = p 0.5 1. 4. in
  let at d = must s (Ray.v (Draw.move q d (-20.)) d) in
  List.iter
    (fun s ->
      check_uv "y and z" (0.25, 0.5) (at (v s 0. 0.));
      check_uv "x and z" (0.25, 0.5) (at (v 0. s 0.));
      check_uv "x and y" (0.25, 0.25) (at (v 0. 0. s)))
    [ 1.; -1. ];
  let flat = Shapes.Box (Made.box (p 0. 0. 3.) (p 2. 4. 3.)) in
  check_uv "a flat box" (0.75, 0.25)
    (must flat (Ray.v (p 1.5 1. 0.) (v 0. 0. 1.)))

let down x y = Ray.v (p x y 5.) (v 0. 0. (-1.))

let uv_of_triangle () =
  let a = p 0. 0. 0. and b = p 4. 0. 0. and c = p 0. 2. 0. in
  let plain = Shapes.Triangle (Made.triangle a b c) in
  check_uv "the weights of corners 2 and 3" (0.25, 0.5)
    (must plain (down 1. 1.));
  let given =
    Made.get "triangle"
      (Triangle.make { a; b; c }
         ~uv:{ ua = 10.; va = 1.; ub = 20.; vb = 3.; uc = -2.; vc = 7. })
  in
  check_uv "those given, mixed"
    ((0.25 *. 10.) +. (0.25 *. 20.) +. (0.5 *. -2.), 0.25 +. 0.75 +. 3.5)
    (must (Shapes.Triangle given) (down 1. 1.))

(* a + u (b - a) + v (c - a) is the point. *)
let triangle_uv { Family.shape; ray } =
  found
    (fun _ l _ ->
      let { Triangle.a; b; c } = shape.Triangle.corners in
      let wb, wc = uv l in
      let at =
        let open Exact in
        let a = point a in
        let side b k = scale (q k) (sub (point b) a) in
        add a (add (side b wb) (side c wc))
      in
      let off = Exact.(sub at (point l.point)) in
      let reach =
        List.fold_left
          (fun m q -> Float.max m (Vec.largest (Point.sub q Point.origin)))
          0. [ a; b; c ]
      in
      wb >= 0. && wc >= 0.
      && wb +. wc <= 1. +. 0x1p-50
      && Q.leq (Exact.largest off) Exact.(power (-49) * q reach))
    { Family.shape = Shapes.Triangle shape; ray }

let smooth_triangle () =
  let a = p 0. 0. 0. and b = p 1. 0. 0. and c = p 0. 1. 0. in
  let normals = (v 0. 0. 5., v 3. 0. 3., v 0. 0.25 0.25) in
  let t = Made.get "triangle" (Triangle.make ~normals { a; b; c }) in
  let at x y = must (Shapes.Triangle t) (down x y) in
  let check name expected (l : Local.t) =
    Alcotest.(check bool) "flat still" true (Dir.equal Dir.z l.normal);
    match (l.smooth, Dir.of_vec expected) with
    | Some { outward = n; _ }, Some e ->
        let n = (n :> Vec.t) and e = (e :> Vec.t) in
        Alcotest.(check bool) name true (Vec.norm (Vec.sub n e) < 1e-14)
    | _ -> Alcotest.failf "%s: no shading normal" name
  in
  let h = sqrt 0.5 in
  check "between corners 1 and 2"
    (v (0.5 *. h) 0. (0.5 +. (0.5 *. h)))
    (at 0.5 0.);
  check "between corners 1 and 3"
    (v 0. (0.5 *. h) (0.5 +. (0.5 *. h)))
    (at 0. 0.5);
  check "in the middle"
    (v (0.25 *. h) (0.5 *. h) (0.25 +. (0.75 *. h)))
    (at 0.25 0.5)

(* The other coordinates, in scene units. *)
let plane_uv { Family.shape = normal; ray } =
  match Quadric.make (Plane { normal; offset = 2. }) with
  | Error _ -> true
  | Ok q ->
      found
        (fun _ l _ ->
          let size i = Float.abs (Vec.get normal i) in
          let first i =
            List.for_all
              (fun j -> size i > size j || (size i = size j && i <= j))
              [ 0; 1; 2 ]
          in
          let left_out = List.find first [ 0; 1; 2 ] in
          match List.filter (( <> ) left_out) [ 0; 1; 2 ] with
          | [ i; j ] -> uv l = (Point.get l.point i, Point.get l.point j)
          | _ -> false)
        { Family.shape = Shapes.Quadric q; ray }

type axial = {
  make : Point.t -> Point.t -> float -> Quadric_shape.t;
  radius_at : float -> float;  (** in units of the radius *)
}

let axials =
  [
    {
      make = (fun from until radius -> Cylinder { from; until; radius });
      radius_at = Fun.const 1.;
    };
    {
      make = (fun apex base radius -> Cone { apex; base; radius });
      radius_at = Fun.id;
    };
    {
      make = (fun apex base radius -> Paraboloid { apex; base; radius });
      radius_at = sqrt;
    };
  ]

type turned = {
  axial : axial;
  first : Point.t;
  axis : Vec.t;
  radius : float;
  height : float;
  turn : float;
  further : float;
}

let turned =
  let open Gen in
  let* axial = Draw.pick axials
  and* first = Draw.point (Draw.uniform (-3.) 3.)
  and* n = oneof [ Draw.axial; Draw.unit ] in
  let* length = Draw.uniform 0.5 4. and* radius = Draw.uniform 0.5 2. in
  let+ height = Draw.uniform 0.05 0.95
  and+ turn = Draw.uniform 0. 1.
  and+ further = oneof [ Draw.uniform 0. 1.; Draw.pick [ 0.25; 0.5; 0.75 ] ] in
  let axis = Vec.scale length n in
  { axial; first; axis; radius; height; turn; further }

(* From the axis outwards, at two turns about it. *)
let axial_uv { axial; first; axis; radius; height; turn; further } =
  let q = Made.quadric (axial.make first (Point.add first axis) radius) in
  let { Frame.u; v = w; _ } = Frame.of_dir (Dir.of_vec_or Dir.z axis) in
  let at turn =
    let a = 2. *. Float.pi *. turn in
    let along k (d : Dir.t) = Vec.scale k (d :> Vec.t) in
    let out = Vec.add (along (cos a) u) (along (sin a) w) in
    let o = Draw.move first axis height in
    match located (Shapes.Quadric q) (Ray.v o out) with
    | None -> Law.fail "missed"
    | Some (l, _) ->
        let r = Vec.norm (Point.sub l.point o) in
        if not (Float.abs (r -. (radius *. axial.radius_at height)) <= 1e-9)
        then Law.fail "met elsewhere";
        uv l
  in
  let u, v = at turn and u', v' = at (turn +. further) in
  let whole x = Float.abs (x -. Float.round x) <= 1e-9 in
  let near x y = Float.abs (x -. y) <= 1e-9 in
  near v height && near v' height && 0. <= u && u <= 1. && 0. <= u' && u' <= 1.
  && whole (u' -. u -. further)

let caps_uv () =
  let s =
    Shapes.Quadric
      (Made.quadric ~caps:true
         (Cylinder { from = p 0. 0. 1.; until = p 0. 0. 3.; radius = 2. }))
  in
  let top = must s (down 0.5 0.5)
  and bottom = must s (Ray.v (p 0.5 0.5 0.) (v 0. 0. 1.)) in
  Alcotest.(check (float 1e-12)) "the second end" 1. (snd (uv top));
  Alcotest.(check (float 1e-12)) "the first end" 0. (snd (uv bottom));
  Alcotest.(check (float 1e-12))
    "the same turn"
    (fst (uv top))
    (fst (uv bottom));
  Alcotest.(check bool) "up" true (Dir.equal Dir.z top.normal);
  Alcotest.(check bool) "down" true (Dir.equal (Dir.neg Dir.z) bottom.normal)

(* Without a gradient the normal is where the ray came from. *)
let apex () =
  let cone =
    Quadric_shape.Cone { apex = Point.origin; base = p 0. 0. 1.; radius = 1. }
  in
  let q = Made.quadric cone in
  let d = v 0. 0. 1. in
  let contact = Contact.v ~part:0 Outside in
  let ray = Object_ray.v (p 0. 0. (-5.)) d in
  let l = Quadric.locate q ray 5. contact in
  Alcotest.(check bool) "the apex" true (Point.equal Point.origin l.point);
  Alcotest.(check bool)
    "back along the ray" true
    (Dir.equal (Dir.neg Dir.z) l.normal)

let law ?(count = 8000) name holds =
  Law.law ~count ~print:Shapes.show_case name Shapes.case (found holds)

let plane_case =
  let open Gen in
  let* n = oneof [ Draw.vec (Draw.small 2); Draw.unit; Draw.axial ] in
  let normal = if Vec.largest n = 0. then v 0. 1. 0. else n in
  let* ray = Draw.ray in
  return { Family.shape = normal; ray }

let suite =
  ( "local",
    [
      law "the normal is unit, the error neither negative nor endless" is_sound;
      law "the normal is towards the outside" faces_outside;
      law "flat is what has no curvature" is_flat;
      law "there is a uv where one is promised, and nowhere else" has_uv;
      Law.example "the uv of a sphere are turn and height" uv_of_sphere;
      Law.law ~count:4000 ~print:(Family.show Spheres.kind)
        "the uv of a sphere are the angles of its normal" Spheres.anything.cases
        sphere_uv;
      Law.example "the uv of a box run over each face, lower axis first"
        uv_of_box;
      Law.example "the uv of a triangle are given, or weights" uv_of_triangle;
      Law.law ~count:4000
        ~print:(Family.show Triangles.kind)
        "the uv of a triangle, if not given, are weights of its point"
        Triangles.ordinary.cases triangle_uv;
      Law.example
        "the normals of a triangle are brought to one length and mixed"
        smooth_triangle;
      Law.law ~count:4000
        ~print:(fun { Family.shape = n; ray } ->
          Draw.show_vec n ^ "\n" ^ Draw.show_ray ray)
        "the uv of a plane leave out the axis its normal is largest in"
        plane_case plane_uv;
      Law.law ~count:4000
        ~print:(fun t ->
          Printf.sprintf
            "axis from %s by %s, radius %h, height %h, turn %h and %h more"
            (Draw.show_point t.first) (Draw.show_vec t.axis) t.radius t.height
            t.turn t.further)
        "the uv about an axis are the turn, counter-clockwise, and the way \
         along"
        turned axial_uv;
      Law.example "the uv of caps go on from those of the side" caps_uv;
      Law.example "the apex of a cone has the normal the ray came from" apex;
    ] )
