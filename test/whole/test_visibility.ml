open Candor_surface
open Candor_scene
open Candor_trace
open Candor_read
open Candor_oracle
open Candor_scene_made

let side = 64

let small (s : Scene.t) =
  {
    s with
    width = side;
    height = side;
    settings = { s.settings with spp = 1; filter = Box };
  }

let show_path = function
  | None -> "nothing"
  | Some path -> String.concat "." (List.map string_of_int path)

(* Every pixel whose surface differs from the exact one. *)
let agrees ?(seen = 2) scene () =
  let scene = small scene in
  let pixel = Pixel.compile scene in
  let wrong = ref [] and surfaces = Hashtbl.create 16 in
  for i = 0 to (side * side) - 1 do
    let x = i mod side and y = i / side in
    let ray = Pixel.ray pixel ~x ~y ~sample:0 in
    let exact = Visible.first scene ray in
    let found =
      Option.map
        (fun (h : _ Hit.t) -> h.path)
        (Surface.nearest (Pixel.surface pixel) ray)
    in
    Hashtbl.replace surfaces exact ();
    if found <> exact then wrong := (x, y, exact, found, ray) :: !wrong
  done;
  (match List.rev !wrong with
  | [] -> ()
  | (x, y, exact, found, ray) :: _ ->
      Alcotest.failf "%d pixels differ, first %d %d: %s instead of %s, %s"
        (List.length !wrong) x y (show_path found) (show_path exact)
        (Draw.show_ray ray));
  if Hashtbl.length surfaces < seen then
    Alcotest.failf "only %d surfaces are seen" (Hashtbl.length surfaces)

(* {1 Scenes in scenes/} *)

let folder = Filename.(concat (dirname Sys.executable_name) "../../scenes")

let file name () =
  match Scene_file.read (Filename.concat folder name) with
  | Ok scene -> agrees scene ()
  | Error report -> Alcotest.failf "%a" Error.pp_report report

(* {1 Scenes made for it} *)

(* Pixel centres at odd multiples of 1/8 from -63/8 to 63/8, seen along -z. *)
let grid_camera =
  "(camera (orthographic (eye 0 0 16) (look-at 0 0 0) (height 16)))"

(* What pixel centres meet exactly: edges and corners of triangles and polygons,
   borders of boxes, tangents of spheres and cylinders, clips and caps. *)
let ties =
  [
    grid_camera;
    "(triangle (-7.875 -7.875 0) (-4.125 -7.875 1) (-7.875 -4.125 2))";
    "(triangle (-4.125 -7.875 1) (-4.125 -4.125 0) (-7.875 -4.125 2))";
    "(polygon (-3.125 -7.875 0) (.875 -7.875 0) (.875 -5.125 0) (-1.125 -6.375 \
     0) (-3.125 -4.125 0))";
    "(box (min 1.875 -7.875 -1) (max 3.875 -5.125 1))";
    "(box (min 3.875 -7.875 -1) (max 5.875 -5.125 1))";
    "(box (min 1.875 -5.125 -2) (max 5.875 -4.125 1))";
    "(sphere (center -5.875 1.125 0) (radius 2))";
    "(sphere (center -1.875 1.125 0) (radius 2))";
    "(sphere (center -3.875 1.125 0) (radius 1))";
    "(quadric (cylinder (from 3.125 -1.875 0) (to 3.125 2.125 0) (radius 1)) \
     (caps))";
    "(quadric (cone (apex 6.125 2.125 0) (base 6.125 -1.875 0) (radius 1.5)) \
     (caps))";
    "(quadric (ellipsoid (center -5.125 5.875 0) (radii 2 1 .5)) (clip (min \
     -6.125 5.125 -9) (max -3.875 9 9)))";
    "(quadric (hyperboloid-one-sheet (center 0 5.625 0) (radii .5 .5 1)) (clip \
     (min -2.125 4.125 -.25) (max 2.125 7.125 3)))";
    "(quadric (paraboloid (apex 4.125 7.875 0) (base 4.125 4.125 0) (radius \
     1.25)) (clip (min 3.125 -9 -9) (max 9 9 9)))";
    "(quadric (plane (normal 0 0 1) (offset -1)) (clip (min -7.125 -7.125 -9) \
     (max 7.125 7.125 9)))";
  ]

(* A transform of these steps rounds nothing. *)
let exact_steps =
  "(transform (scale .5) (rotate (axis 0 1 0) (degrees 90)) (translate .25 \
   -1.5 2) (scale 4 2 1) (rotate (axis 1 0 0) (degrees -90)) (translate 0 1 \
   -4))"

let bodies =
  [
    "(sphere (center -1 .5 0) (radius .75))";
    "(box (min .25 -1 -.5) (max 1.5 .5 .75))";
    "(triangle (-2 -1 1) (2 -1.25 1) (0 -2 -1))";
    "(quadric (cylinder (from 0 1 0) (to 1 2 .5) (radius .25)) (caps))";
    "(quadric (cone (apex -1 2 0) (base -1.5 .75 .5) (radius .5)) (caps))";
    "(quadric (hyperbolic-paraboloid (center 0 -1 0) (radii 1 1 1)) (clip (min \
     -1 -2 -1) (max 1 0 1)))";
    "(polygon (1 1 1) (2 1 1) (2 2 1) (1.5 1.5 1) (1 2 1))";
  ]

let nested =
  [
    "(camera (perspective (eye 3 2 9) (look-at 0 0 -2) (fov-y 60)))";
    "(group " ^ exact_steps;
    String.concat "\n" bodies;
    "(group " ^ exact_steps;
    String.concat "\n" bodies;
    "))";
    "(quadric (plane (normal 0 1 0) (offset -4)))";
  ]

(* The same camera, in transforms that are doubles but round what they move. *)
let turned =
  [
    "(camera (perspective (eye .3 .2 9) (look-at 0 0 0) (fov-y 50)))";
    "(group (transform (rotate (axis 1 2 3) (degrees 37)) (scale 1.3 .7 1.1) \
     (translate .1 .2 .3))";
    String.concat "\n" bodies;
    "(group (transform (rotate (axis -2 1 1) (degrees 111)) (scale .8) \
     (translate .7 -1.1 .4))";
    String.concat "\n" bodies;
    "))";
  ]

(* A sphere of 10^5 for each wall, and things far smaller and farther away than
   each other. *)
let sizes =
  [
    "(camera (perspective (eye .1 .2 .9) (look-at 0 0 -1) (fov-y 80)))";
    "(sphere (center 100001 0 0) (radius 100000))";
    "(sphere (center -100001 0 0) (radius 100000))";
    "(sphere (center 0 100001 0) (radius 100000))";
    "(sphere (center 0 -100001 0) (radius 100000))";
    "(quadric (ellipsoid (center 0 0 -1e9) (radii 1e9 1e8 1e7)))";
    "(quadric (cylinder (from 0 0 -1) (to 1e-3 1 -1e3) (radius 1e-2)))";
    "(box (min -.3 -.2 -1e6) (max -.2 .2 -2))";
    "(triangle (.2 -.4 -.5) (.4 -.4 -1e4) (.3 .5 -.5))";
    "(sphere (center .1 .2 .89) (radius 1e-3))";
  ]

let made name forms =
  Law.example name (fun () -> agrees (Written.scene forms) ())

let suite =
  ( "primary visibility",
    List.map
      (fun name ->
        Law.example
          (Printf.sprintf "%s: 64x64 rational pixels, 0 differ" name)
          (file name))
      [
        "several-shapes.scene";
        "cornell-box.scene";
        "quadrics.scene";
        "polygon.scene";
        "orthographic.scene";
        "horizon.scene";
        "wada.scene";
        "spot-lights.scene";
        "glazed-floor.scene";
        "hero.scene";
        "groups.scene";
        "window.scene";
      ]
    @ [
        made "rays through edges, corners, tangents, clips and rims exactly"
          ties;
        made "groups that round nothing, nested" nested;
        made "groups that turn and stretch, nested" turned;
        made "sizes from 1e-3 to 1e9 in one view" sizes;
      ] )
