(** Closed convex bodies about the origin, all within 2 of it: to be seen from
    outside, or as rooms from inside. *)

let group surfaces = "(group " ^ String.concat " " surfaces ^ ")"

let cube_of_triangles =
  (* Corners by the bits of their number; each face counter-clockwise. *)
  let corner i =
    let at bit = if i land bit = 0 then "-1" else "1" in
    Printf.sprintf "(%s %s %s)" (at 1) (at 2) (at 4)
  in
  let triangle a b c =
    Printf.sprintf "(triangle %s %s %s)" (corner a) (corner b) (corner c)
  in
  let face (a, b, c, d) = [ triangle a b c; triangle a c d ] in
  group
    (List.concat_map face
       [
         (0, 4, 6, 2);
         (1, 3, 7, 5);
         (0, 1, 5, 4);
         (2, 6, 7, 3);
         (0, 2, 3, 1);
         (4, 5, 7, 6);
       ])

let planes =
  group
    (List.map
       (fun n -> Printf.sprintf "(quadric (plane (normal %s) (offset 1)))" n)
       [ "1 0 0"; "-1 0 0"; "0 1 0"; "0 -1 0"; "0 0 1"; "0 0 -1" ])

(* As in smallpt: walls are spheres of 10^5 units. *)
let six_spheres =
  group
    (List.map
       (fun c -> Printf.sprintf "(sphere (center %s) (radius 100000))" c)
       [
         "99999 0 0";
         "-99999 0 0";
         "0 99999 0";
         "0 -99999 0";
         "0 0 99999";
         "0 0 -99999";
       ])

let bodies =
  [
    ("a sphere", "(sphere (center 0 0 0) (radius 1))");
    ("a box", "(box (min -1 -1 -1) (max 1 1 1))");
    ("an ellipsoid", "(quadric (ellipsoid (center 0 0 0) (radii 1 .9 .8)))");
    ( "a cylinder",
      "(quadric (cylinder (from 0 -1 0) (to 0 1 0) (radius 1)) (caps))" );
    ("a cone", "(quadric (cone (apex 0 2 0) (base 0 -1 0) (radius 1.5)) (caps))");
    ( "a paraboloid",
      "(quadric (paraboloid (apex 0 -1 0) (base 0 1 0) (radius 1)) (caps))" );
    ("twelve triangles", cube_of_triangles);
    ( "an octahedron",
      group
        [
          "(triangle (1 0 0) (0 1 0) (0 0 1))";
          "(triangle (0 1 0) (-1 0 0) (0 0 1))";
          "(triangle (-1 0 0) (0 -1 0) (0 0 1))";
          "(triangle (0 -1 0) (1 0 0) (0 0 1))";
          "(triangle (0 1 0) (1 0 0) (0 0 -1))";
          "(triangle (-1 0 0) (0 1 0) (0 0 -1))";
          "(triangle (0 -1 0) (-1 0 0) (0 0 -1))";
          "(triangle (1 0 0) (0 -1 0) (0 0 -1))";
        ] );
  ]

let rooms = bodies @ [ ("six planes", planes); ("six spheres", six_spheres) ]
