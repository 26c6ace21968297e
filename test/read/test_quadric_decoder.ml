open Candor_space
open Candor_surface
open Text

let read body =
  match (only_surface (Printf.sprintf "(quadric %s)" body)).shape with
  | Quadric q -> q
  | Mesh _ | Group _ | Sphere _ | Box _ | Triangle _ | Polygon _ | Use _ ->
      Alcotest.fail "not a quadric"

let check s shape =
  Alcotest.(check bool)
    s true
    (Quadric_shape.equal shape (Quadric.shape (read s)))

let shapes () =
  let p = Point.v 1. 2. 3. and q = Point.v 4. 5. 7. and radius = 2. in
  let radii = Vec.v 1. 2. 3. in
  let ends = "(apex 1 2 3) (base 4 5 7) (radius 2)" in
  let about = "(center 1 2 3) (radii 1 2 3)" in
  check "(plane (normal 0 2 0) (offset -1))"
    (Plane { normal = Vec.v 0. 2. 0.; offset = -1. });
  check
    (Printf.sprintf "(ellipsoid %s)" about)
    (Ellipsoid { center = p; radii });
  check "(cylinder (from 1 2 3) (to 4 5 7) (radius 2))"
    (Cylinder { from = p; until = q; radius });
  check (Printf.sprintf "(cone %s)" ends) (Cone { apex = p; base = q; radius });
  check
    (Printf.sprintf "(paraboloid %s)" ends)
    (Paraboloid { apex = p; base = q; radius });
  check
    (Printf.sprintf "(hyperbolic-paraboloid %s)" about)
    (Hyperbolic_paraboloid { center = p; radii });
  check
    (Printf.sprintf "(hyperboloid-one-sheet %s)" about)
    (Hyperboloid_one_sheet { center = p; radii });
  check
    (Printf.sprintf "(hyperboloid-two-sheets %s)" about)
    (Hyperboloid_two_sheets { center = p; radii })

let general () =
  let q =
    [| 1.; 2.; 0.; 0.; 2.; 1.; 0.; 0.; 0.; 0.; 1.; 0.; 0.; 0.; 0.; -1. |]
  in
  check "(matrix 1 2 0 0 2 1 0 0 0 0 1 0 0 0 0 -1)" (Matrix q);
  let a = [| 1.; 2.; 0.; 2.; 1.; 0.; 0.; 0.; 1. |] in
  check "(form (a 1 2 0 2 1 0 0 0 1) (b 1 2 3) (c 4))"
    (Form { a; b = Vec.v 1. 2. 3.; c = 4. })

let defaults () =
  let q = read "(cylinder (from 0 0 0) (to 0 1 0) (radius 1))" in
  Alcotest.(check bool) "no caps" false (Quadric.caps q);
  Alcotest.(check bool) "no clip" true (Option.is_none (Quadric.clip q))

let cut () =
  let q =
    read
      "(caps) (clip (min -1 -1 -1) (max 1 1 1)) (cylinder (from 0 0 0) (to 0 1 \
       0) (radius 1))"
  in
  Alcotest.(check bool) "caps" true (Quadric.caps q);
  Alcotest.(check bool)
    "clip" true
    (Option.equal Bounds.equal
       (Some (Bounds.v (Point.v (-1.) (-1.) (-1.)) (Point.v 1. 1. 1.)))
       (Quadric.clip q))

let suite =
  ( "quadric decoder",
    [
      case "each named shape is read" shapes;
      case "matrices and forms are read row by row" general;
      case "a quadric is open and not clipped unless told otherwise" defaults;
      case "clip and caps are read" cut;
    ] )
