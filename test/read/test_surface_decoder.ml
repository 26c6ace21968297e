open Candor_space
open Candor_surface
open Candor_scene
open Text

let shape forms = (only_surface forms).shape

let sphere () =
  match shape "(sphere (center 1 2 3) (radius .25))" with
  | Sphere s ->
      Alcotest.(check bool)
        "sphere" true
        (Point.equal (Sphere.center s) (Point.v 1. 2. 3.) && s.radius = 0.25)
  | Box _ | Triangle _ | Quadric _ | Polygon _ | Group _ | Mesh _ | Use _ ->
      Alcotest.fail "not a sphere"

let box () =
  match shape "(box (max 4 5 3) (min 1 2 3))" with
  | Box b ->
      Alcotest.(check bool)
        "box" true
        (Bounds.equal
           (b :> Bounds.t)
           (Bounds.v (Point.v 1. 2. 3.) (Point.v 4. 5. 3.)))
  | Sphere _ | Triangle _ | Quadric _ | Polygon _ | Group _ | Mesh _ | Use _ ->
      Alcotest.fail "not a box"

let triangle forms =
  match shape forms with
  | Triangle t -> t
  | Sphere _ | Box _ | Quadric _ | Polygon _ | Group _ | Mesh _ | Use _ ->
      Alcotest.fail "not a triangle"

let triangles () =
  let t = triangle "(triangle (0 0 0) (1 0 0) (0 1 0))" in
  Alcotest.(check bool)
    "corners" true
    (Point.equal t.corners.b (Point.v 1. 0. 0.));
  Alcotest.(check bool) "normals" true (Option.is_none t.normals);
  Alcotest.(check bool) "uv" true (Option.is_none t.uv);
  let t =
    triangle
      "(triangle (0 0 0) (1 0 0) (0 1 0) (uv (1 2) (3 4) (5 6)) (normals (0 0 \
       2) (0 0 3) (0 4 0)))"
  in
  let uv = { Triangle.ua = 1.; va = 2.; ub = 3.; vb = 4.; uc = 5.; vc = 6. } in
  Alcotest.(check bool)
    "uv" true
    (Option.equal Triangle.equal_uv (Some uv) t.uv);
  match t.normals with
  | Some (a, b, c) ->
      Alcotest.(check bool)
        "normals" true
        (Vec.equal a (Vec.v 0. 0. 2.)
        && Vec.equal b (Vec.v 0. 0. 3.)
        && Vec.equal c (Vec.v 0. 4. 0.))
  | None -> Alcotest.fail "no normals"

let polygon () =
  match shape "(polygon (0 0 0) (2 0 0) (1 0 1) (0 0 2))" with
  | Polygon p -> Alcotest.(check int) "corners" 4 (List.length p.corners)
  | Sphere _ | Box _ | Triangle _ | Quadric _ | Group _ | Mesh _ | Use _ ->
      Alcotest.fail "not a polygon"

let group () =
  let s =
    only_surface
      "(group (sphere (center 0 0 0) (radius 1)) (material (mirror)) (group) \
       (box (min 0 0 0) (max 1 1 1)))"
  in
  match s with
  | {
   shape = Group { transform = []; surfaces = [ a; b; c ] };
   material = Some _;
   _;
  } -> (
      match (a.shape, b.shape, c.shape) with
      | Sphere _, Group { transform = []; surfaces = [] }, Box _ -> ()
      | _ -> Alcotest.fail "not the surfaces in their order")
  | _ -> Alcotest.fail "not a group of three with a material"

let use () =
  let s =
    ok_forms
      "(use tree (transform (scale 2)) (material (mirror))) (use tree) (define \
       tree (sphere (center 0 0 0) (radius 1)) (box (min 0 0 0) (max 1 1 1)))"
  in
  match (s.surfaces, s.definitions) with
  | ( [
        {
          shape = Use { transform = [ _ ]; name = "tree" };
          material = Some _;
          _;
        };
        { shape = Use { transform = []; name = "tree" }; material = None; _ };
      ],
      [ { name = "tree"; value = [ _; _ ]; _ } ] ) ->
      ()
  | _ -> Alcotest.fail "not two uses of a definition"

let attributes () =
  let s = only_surface "\n(sphere (center 0 0 0) (radius 1))" in
  Alcotest.(check bool) "material" true (Option.is_none s.material);
  Alcotest.(check string) "place" "test.scene:2:1" (Place.to_string s.place);
  is "still" true (Scene.is_still s);
  is "one side" false s.both_sides

let moving () =
  let check forms =
    let s =
      only_surface (Printf.sprintf forms "(motion 1 -2 .5) (both-sides)")
    in
    is "motion" true (Vec.equal s.motion (Vec.v 1. (-2.) 0.5));
    is "both sides" true s.both_sides
  in
  check "(sphere (center 0 0 0) (radius 1) %s)";
  check "(box (min 0 0 0) (max 1 1 1) %s)";
  check "(triangle (0 0 0) (1 0 0) (0 1 0) %s)";
  check "(quadric (plane (normal 0 1 0) (offset 0)) %s)";
  check "(polygon (0 0 0) (1 0 0) (0 1 0) %s)";
  check "(group %s (sphere (center 0 0 0) (radius 1)))";
  check "(use a %s) (define a (sphere (center 0 0 0) (radius 1)))";
  errors "a motion is a vector"
    [ "2:35 expected (motion X Y Z), found 1 word" ]
    (scene "\n(sphere (center 0 0 0) (radius 1) (motion 1))")

let suite =
  ( "surface decoder",
    [
      case "a sphere is read" sphere;
      case "a box may be flat and its fields in any order" box;
      case "a triangle has no normals nor uv unless told otherwise" triangles;
      case "a polygon keeps its corners" polygon;
      case "a group keeps the order of its surfaces" group;
      case "a definition may be used before it is made" use;
      case "a surface knows its place and names no material of itself"
        attributes;
      case "any surface may move, and emit from both sides" moving;
    ] )
