open Candor_space
open Candor_surface
open Candor_read
open Text

let made faces =
  let b = Faces.start () in
  let corner (x, y, z) = Faces.corner (Point.v x y z) in
  List.iter
    (fun face -> Faces.add b (Array.of_list (List.map corner face)))
    faces;
  Faces.finish b

let flat = List.map (fun (x, y) -> (x, y, 0.))
let check name faces expected = Meshes.check name made expected faces

let convex () =
  check "a square"
    [ flat [ (0., 0.); (1., 0.); (1., 1.); (0., 1.) ] ]
    [ "0 dropped"; "(0 0 0)(1 0 0)(1 1 0)"; "(0 0 0)(1 1 0)(0 1 0)" ];
  check "not quite flat"
    [ [ (0., 0., 0.); (1., 0., 0.1); (1., 1., 0.); (0., 1., 0.1) ] ]
    [ "0 dropped"; "(0 0 0)(1 0 0.1)(1 1 0)"; "(0 0 0)(1 1 0)(0 1 0.1)" ]

let concave () =
  check "an arrowhead"
    [ flat [ (0., 0.); (4., -2.); (1., 0.); (4., 2.) ] ]
    [ "0 dropped"; "(0 0 0)(4 -2 0)(1 0 0)"; "(1 0 0)(4 2 0)(0 0 0)" ];
  check "its corners are not quite in a plane"
    [ [ (0., 0., 0.); (4., -2., 0.1); (1., 0., 0.); (4., 2., 0.) ] ]
    [ "0 dropped"; "(0 0 0)(4 -2 0.1)(1 0 0)"; "(1 0 0)(4 2 0)(0 0 0)" ]

let dropped () =
  let needle = flat [ (0., 0.); (1., 1.); (2., 2.) ] in
  check "a needle, a triangle and a point"
    [
      needle;
      flat [ (0., 0.); (1., 0.); (0., 1.) ];
      flat [ (1., 1.); (1., 1.); (1., 1.); (1., 1.) ];
    ]
    [ "2 dropped"; "(0 0 0)(1 0 0)(0 1 0)" ];
  check "a corner in a side"
    [ flat [ (0., 0.); (1., 0.); (2., 0.); (0., 2.) ] ]
    [ "0 dropped"; "(0 0 0)(1 0 0)(0 2 0)"; "(1 0 0)(2 0 0)(0 2 0)" ];
  Meshes.refused (fun _ -> made []) "the file has no faces" "no faces";
  Meshes.refused
    (fun _ -> made [ needle ])
    "no face of the file has an area" "a needle"

let area (t : Triangle.t) =
  let { Triangle.a; b; c } = t.corners in
  Vec.cross (Point.sub b a) (Point.sub c a)

(* Faces around the origin, star-shaped, tilted and not quite flat: the areas of
   the triangles add up to the face's. *)
let star =
  let open QCheck2.Gen in
  let* n = int_range 4 12 and+ tilt = float_range (-3.) 3. in
  let+ radii = list_size (return n) (float_range 0.3 2.) in
  let corner i r =
    let a = 2. *. Float.pi *. float_of_int i /. float_of_int n in
    let round x = Float.round (x *. 1e6) /. 1e6 in
    let x = r *. cos a and y = r *. sin a in
    (round x, round y, round ((tilt *. x) +. y))
  in
  List.mapi corner radii

let covers scale face =
  let scaled (x, y, z) = (scale *. x, scale *. y, scale *. z) in
  match made [ List.map scaled face ] with
  | Error why -> QCheck2.Test.fail_report why
  | Ok { triangles; dropped } ->
      let sum =
        Array.fold_left (fun s t -> s +. Vec.norm (area t)) 0. triangles
      in
      let corners = Array.of_list face in
      let n = Array.length corners in
      let swept i =
        let point (x, y, z) = Vec.v x y z in
        Vec.cross (point corners.(i)) (point corners.((i + 1) mod n))
      in
      let whole =
        List.fold_left
          (fun s i -> Vec.add s (swept i))
          Vec.zero (List.init n Fun.id)
      in
      dropped = 0
      && Array.length triangles = n - 2
      && Array.for_all (fun t -> Vec.dot (area t) whole > 0.) triangles
      && Float.abs (sum -. (scale *. scale *. Vec.norm whole))
         <= 1e-4 *. scale *. scale

let print face =
  String.concat " "
    (List.map (fun (x, y, z) -> Printf.sprintf "(%g %g %g)" x y z) face)

let suite =
  ( "faces",
    [
      case "a convex face fans out from its first corner" convex;
      case "a face that is not is cut along its inside" concave;
      case "what has no area is left out, and counted if it is a face" dropped;
      law ~count:500 ~print
        "faces with any number of corners are covered once, nearly flat or not"
        star (covers 1.);
      law ~count:100 ~print "however large they are" star (fun face ->
          covers 0x1p300 face && covers 0x1p-300 face);
    ] )
