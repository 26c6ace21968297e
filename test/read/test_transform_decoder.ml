open Candor_space
open Text

let read steps =
  match
    (only_surface (Printf.sprintf "(group (transform %s))" steps)).shape
  with
  | Group { transform; surfaces = [] } -> transform
  | Mesh _ | Group _ | Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _
  | Use _ ->
      Alcotest.fail "not an empty group"

let check s steps =
  Alcotest.(check bool) s true (List.equal Transform.equal_step steps (read s))

let steps () =
  check "" [];
  check "(translate 1 2 3)" [ Translate (Vec.v 1. 2. 3.) ];
  check "(scale 2)" [ Scale (Vec.v 2. 2. 2.) ];
  check "(scale 2 3 -4)" [ Scale (Vec.v 2. 3. (-4.)) ];
  check "(rotate (axis 0 0 2) (degrees -450))"
    [ Rotate { axis = Vec.v 0. 0. 2.; degrees = -450. } ]

let matrix () =
  let m : Affine.t =
    {
      xx = 1.; xy = 2.; xz = 3.; xt = 4.;
      yx = 0.; yy = 5.; yz = 6.; yt = 7.;
      zx = 0.; zy = 0.; zz = 8.; zt = 9.;
    } [@ocamlformat "disable"]
  in
  check "(matrix 1 2 3 4 0 5 6 7 0 0 8 9)" [ Matrix m ]

let order () =
  check "(scale 2) (translate 1 0 0) (scale 3)"
    [
      Scale (Vec.v 2. 2. 2.); Translate (Vec.v 1. 0. 0.); Scale (Vec.v 3. 3. 3.);
    ]

let suite =
  ( "transform decoder",
    [
      case "each step is read" steps;
      case "a matrix is read row by row" matrix;
      case "steps keep their order" order;
    ] )
