(* Rows of the catalogue of hard cases that are families, or that no module's own
   test names. *)

open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families

let p = Point.v
let v = Vec.v
let example = Law.example

(* {1 Spheres} *)

let nearest s ray = Surface.nearest (Surface.sphere s ()) ray

(* A ray that leaves a hit meets the sphere again if and only if it goes
   inwards. Directions along the surface, as far as the point is known, may
   count as either. *)
let bounce ({ Family.shape; ray }, d) =
  match nearest shape ray with
  | None -> true
  | Some h ->
      let n = (h.local.normal :> Vec.t) in
      let slope = Vec.dot n d in
      let far = Vec.largest (Point.sub h.point Point.origin) in
      Float.abs slope < 0x1p-40 +. (0x1p-48 *. far /. shape.radius)
      ||
      let again = nearest shape (Hit.spawn h d) in
      (match again with
        | None -> slope > 0.
        | Some h -> slope < 0. && h.side = Inside)
      || Law.fail "slope %g" slope

let bounces =
  Law.law ~count:5000
    ~print:(fun (c, d) ->
      Family.show Spheres.kind c ^ "\nthen along " ^ Draw.show_vec d)
    "S15: a ray from a computed hit meets the sphere again iff it goes inwards"
    QCheck2.Gen.(pair Spheres.anything.cases Draw.unit)
    bounce

(* As small and as far as other programs no longer see. *)
let visible () =
  List.iter
    (fun (radius, far) ->
      let s = Made.sphere (p 0. 0. far) radius in
      match nearest s (Ray.v Point.origin (v 0. 0. 1.)) with
      | Some h when Exact.within 1. h.t Exact.(q far - q radius) -> ()
      | _ -> Alcotest.failf "radius %g at %g is not seen" radius far)
    [ (1e-5, 1.); (1e-9, 1.); (0x1p-300, 0x1p-298); (1., 1e8); (1e-5, 1e7) ]

(* Seen from 3200 away the limb is the same wherever the scene is: all
   coordinates stay whole. *)
let limb () =
  let at x =
    let s = Made.sphere (p x 0. 0.) 1. in
    List.init 2001 (fun i ->
        let d = v (float_of_int (i - 1000) *. 0x1p-10) 0. (-3200.) in
        Option.map
          (fun (h : _ Hit.t) -> h.t)
          (nearest s (Ray.v (p x 0. 3200.) d)))
  in
  let here = at 0. in
  List.iter
    (fun x ->
      Alcotest.(check (list (option (float 0.))))
        (Printf.sprintf "at %g" x) here (at x))
    [ 8e5; 0x1p20; 0x1p40; -0x1p50 ]

let spheres =
  let agrees name = Family.agrees name Spheres.kind in
  [
    agrees "S9: six walls of radius 1e5 from in the room" ~ulps:5. Spheres.f1;
    agrees "S10: grazing rays within 1e-3..1e-15 of the radius" ~ulps:5.
      Spheres.f3;
    bounces;
    example "S17: spheres of any size are seen at any distance" visible;
    agrees "S18: directions of length 1e-4..1e4" ~ulps:5. Spheres.f7;
    example "S19: a limb is the same wherever the scene is" limb;
  ]

(* {1 Boxes} *)

let boxes =
  [
    Family.agrees "B4: corners and edges of boxes from up to 1e5 away"
      Boxes.kind ~ulps:2. Boxes.aimed;
  ]

(* {1 Triangles} *)

let needles =
  let decides name a b c o target =
    let shape = Made.triangle a b c in
    Family.decides name Triangles.kind ~ulps:4.
      { shape; ray = Ray.v o (Draw.toward o target) }
  in
  let x = 148376. and y = 1234. and z = -223423. in
  [
    decides "T10: a needle of 1 by 1e-12, met within" (p 0. 0. 0.) (p 1. 0. 0.)
      (p 0.5 1e-12 0.) (p 0.25 3. 7.) (p 0.5 2.5e-13 0.);
    decides "T10: a needle of 1 by 1e-12, missed by as much" (p 0. 0. 0.)
      (p 1. 0. 0.) (p 0.5 1e-12 0.) (p 0.25 3. 7.) (p 0.5 2e-12 0.);
    decides "T10: a sliver 1e9 long" (p 0. 0. 0.) (p 1e9 1. 0.) (p 1e9 1. 1.)
      (p 5e8 7e8 3.) (p 5e8 0.5 0.25);
    decides "T10: a small triangle far from the origin" (p x y z)
      (p (x +. 0.125) y z)
      (p x (y +. 0.125) z)
      (p (x +. 3.) (y -. 2.) (z +. 9.))
      (p (x +. 0.0625) (y +. 0.0625) z);
  ]

let triangles =
  Family.agrees "T5: rays within 1e-1..1e-12 of the plane" Triangles.kind
    ~ulps:4. Triangles.t5
  :: Family.agrees "T10: needles and slivers" Triangles.kind ~ulps:4.
       Triangles.needles
  :: needles

(* {1 Quadrics} *)

let quadrics =
  let agrees ?(ulps = 6.) name = Family.agrees name Quadrics.kind ~ulps in
  [
    agrees "Q2: a cone along its generators" Quadrics.k3;
    agrees "Q2: a hyperboloid along its generators" Quadrics.k5;
    agrees "Q8: an ellipsoid from up to 1e6 away" Quadrics.k1;
    agrees "Q8: a cone from up to 1e6 away" Quadrics.k2;
    agrees "Q8: any of five, turned, from up to 1e6 away" Quadrics.k7;
    agrees ~ulps:4. "Q9: grazing an ellipsoid within 1e-3..1e-14" Quadrics.k8;
    agrees "Q10: an ellipsoid of 1 by 1e-6 by 1e3" Quadrics.thin;
  ]

(* {1 Groups and what is made} *)

let transform steps = Made.get "transform" (Transform.of_steps steps)

(* Seen in a mirror, everything is as it was: t, side and part; point and normal
   are mirrored. *)
let reflected ({ Family.shape; ray }, axis) =
  let c = Shapes.mirror axis in
  let mirror = transform [ Scale (c.normal (v 1. 1. 1.)) ] in
  let s = Surface.group [| Shapes.surface () shape |] in
  let there = Surface.seen_through ~transform:mirror s in
  match
    (Surface.nearest s ray, Surface.nearest there (Shapes.change_ray c ray))
  with
  | None, None -> true
  | Some a, Some b ->
      (* Once more brought to length 1, which rounds. *)
      let mirrors (n : Dir.t) (n' : Dir.t) =
        let off = Vec.sub (c.normal (n :> Vec.t)) (n' :> Vec.t) in
        Vec.largest off <= 0x1p-51
      in
      a.t = b.t && a.side = b.side && a.part = b.part
      && Point.equal (c.point a.point) b.point
      && mirrors a.normal b.normal
      && mirrors a.shading_normal b.shading_normal
  | Some _, None -> Law.fail "missed in the mirror"
  | None, Some _ -> Law.fail "met in the mirror alone"

(* Normals go through the inverse, transposed: at right angles to where
   tangents go, on the side that the ray comes from, whatever the map turns
   over. *)
let normal_of_image ({ Family.shape; ray }, (scale, along)) =
  let m = transform [ Scale scale; Rotate { axis = along; degrees = 40. } ] in
  let there = Affine.(vector (Transform.forward m).high) in
  let origin = Affine.point (Transform.forward m).high ray.origin in
  let s = Surface.group [| Shapes.surface () shape |] in
  match
    Surface.nearest
      (Surface.seen_through ~transform:m s)
      (Ray.v origin (there ray.direction))
  with
  | None -> true
  | Some h ->
      let n = (h.normal :> Vec.t) and inner = (h.local.normal :> Vec.t) in
      let flat a =
        let a = there (Vec.cross inner a) in
        Float.abs (Vec.dot n a) <= 0x1p-44 *. Float.max 1. (Vec.norm a)
      in
      let outwards = Vec.dot n (there inner) > 0. in
      List.for_all flat Vec.[ v 1. 0. 0.; v 0. 1. 0.; v 0. 0. 1. ]
      && outwards = (h.side = Outside)

(* No surface can be made with a number that is none: nothing later has to look
   for one. *)
let rejected () =
  let q = p 1. 2. 3. and r = v 1. 2. 3. in
  let check what = function
    | Error why -> Alcotest.(check bool) what true (why <> "")
    | Ok () -> Alcotest.failf "%s is accepted" what
  in
  let made what result = check what (Result.map ignore result) in
  let quadric what shape = made what (Quadric.make shape) in
  let with_number x =
    let called = Printf.sprintf "%s with %g" in
    let bad = p 0. x 0. and bad_radii = v 1. x 1. in
    made (called "a sphere at" x) (Sphere.make ~center:bad ~radius:1.);
    made (called "a sphere" x) (Sphere.make ~center:q ~radius:x);
    made (called "a box" x) (Box.make ~min:Point.origin ~max:(p 1. x 1.));
    made (called "a triangle" x)
      (Triangle.make { a = Point.origin; b = p 1. 0. 0.; c = bad });
    quadric (called "a plane" x) (Plane { normal = bad_radii; offset = 1. });
    quadric (called "a plane at" x) (Plane { normal = r; offset = x });
    quadric (called "an ellipsoid" x)
      (Ellipsoid { center = q; radii = bad_radii });
    quadric (called "a cylinder" x)
      (Cylinder { from = q; until = bad; radius = 1. });
    quadric (called "a cone" x) (Cone { apex = q; base = bad; radius = 1. });
    quadric (called "a paraboloid" x)
      (Paraboloid { apex = q; base = Point.origin; radius = x });
    quadric (called "a saddle" x)
      (Hyperbolic_paraboloid { center = bad; radii = r });
    quadric (called "a hyperboloid" x)
      (Hyperboloid_one_sheet { center = bad; radii = r });
    quadric (called "a matrix" x) (Quadrics.form x 1. 1. Vec.zero (-1.));
    made (called "a polygon" x) (Polygon.make [ Point.origin; p 1. 0. 0.; bad ]);
    made (called "a transform" x) (Transform.of_steps [ Translate bad_radii ])
  in
  List.iter with_number [ nan; infinity; neg_infinity ]

(* {1 Thin slabs} *)

(* The faces that are crossed on the way through: a slab's place and the side
   that the face is met from. *)
let crossed s ray =
  let rec on n (ray : Ray.t) =
    match Surface.nearest s ray with
    | Some (h : _ Hit.t) when n > 0 ->
        (List.hd h.path, h.side) :: on (n - 1) (Hit.spawn h ray.direction)
    | Some _ | None -> []
  in
  on 9 ray

type slabs = { near : float; thick : float; gap : float; ray : Ray.t }

let show_slabs { near; thick; gap; ray } =
  Printf.sprintf "slabs at %h, %h thick, %h apart\n%s" near thick gap
    (Draw.show_ray ray)

let slabs =
  let open QCheck2.Gen in
  let* near = Draw.pick [ 0.; 1.; 1e3; -1e3 ] in
  let* thick = Draw.pick [ 1e-9; 1. ] and* gap = Draw.pick [ 1e-9; 1e-10 ] in
  let* x = Draw.uniform (-1.) 1. and* y = Draw.uniform (-1.) 1. in
  let* steep = Draw.wide (-4.) 0. and* far = Draw.wide (-9.) 1. in
  let d = v x y steep in
  let o = p (-.x *. far) (-.y *. far) (near -. (steep *. far)) in
  return { near; thick; gap; ray = Ray.v o d }

let in_order { near; thick; gap; ray } =
  let slab z =
    let wide = 0x1p30 in
    Surface.box (Made.box (p (-.wide) (-.wide) z) (p wide wide (z +. thick))) ()
  in
  let two = Surface.group [| slab near; slab (near +. thick +. gap) |] in
  (not (ray.origin.z < near))
  || crossed two ray
     = Side.[ (0, Outside); (0, Inside); (1, Outside); (1, Inside) ]

let pipeline =
  [
    Law.law
      ~print:(fun (c, k) -> Printf.sprintf "%s\naxis %d" (Shapes.show_case c) k)
      "G3: in a group that mirrors, surfaces are met as they are"
      QCheck2.Gen.(pair Shapes.case (int_bound 2))
      reflected;
    Law.law
      ~print:(fun (c, (scale, along)) ->
        Printf.sprintf "%s\nscaled by %s, turned about %s" (Shapes.show_case c)
          (Draw.show_vec scale) (Draw.show_vec along))
      "G3: normals are at right angles to what scales stretch and turn over"
      QCheck2.Gen.(
        pair Shapes.case
          (pair (Draw.vec (Draw.signed (Draw.uniform 0.25 4.))) Draw.unit))
      normal_of_image;
    example "G6: nothing is made of nan or infinity" rejected;
    Law.law ~count:5000 ~print:show_slabs
      "G22: slabs 1e-9 thick and apart are entered and left in order" slabs
      in_order;
  ]

let suite =
  ("catalogue", List.concat [ spheres; boxes; triangles; quadrics; pipeline ])
