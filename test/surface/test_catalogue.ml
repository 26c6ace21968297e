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
  let agrees name = Family.agrees name Quadrics.kind ~ulps:4. in
  [
    agrees "Q2: a cone along its generators" Quadrics.k3;
    agrees "Q2: a hyperboloid along its generators" Quadrics.k5;
    agrees "Q8: an ellipsoid from up to 1e6 away" Quadrics.k1;
    agrees "Q8: a cone from up to 1e6 away" Quadrics.k2;
    agrees "Q8: any of five, turned, from up to 1e6 away" Quadrics.k7;
    agrees "Q9: grazing an ellipsoid within 1e-3..1e-14" Quadrics.k8;
    agrees "Q10: an ellipsoid of 1 by 1e-6 by 1e3" Quadrics.thin;
  ]

let suite = ("catalogue", List.concat [ spheres; boxes; triangles; quadrics ])
