open Candor_space
open Candor_scene
open Text

let read camera = (ok (Printf.sprintf "(scene (camera %s))" camera)).camera
let view = "(eye 0 1 5) (look-at 0 1 0)"

let frames () =
  let check s (frame : Camera.frame) =
    Alcotest.(check bool) s true (Camera.equal_frame frame (read s).frame)
  in
  let window = { Camera.left = -1.; right = 2.; bottom = -3.; top = 4. } in
  check
    (Printf.sprintf "(perspective %s (fov-y 40))" view)
    (Perspective_angle { fov_y = 40. });
  check
    (Printf.sprintf "(perspective %s (window -1 2 -3 4) (distance 2))" view)
    (Perspective_window { window; distance = 2. });
  check
    (Printf.sprintf "(orthographic %s (height 3))" view)
    (Orthographic_height { height = 3. });
  check
    (Printf.sprintf "(orthographic %s (window -1 2 -3 4))" view)
    (Orthographic_window { window })

let defaults () =
  let c = read (Printf.sprintf "(perspective %s (fov-y 40))" view) in
  Alcotest.(check bool) "up" true (Vec.equal c.up (Vec.v 0. 1. 0.));
  Alcotest.(check (option (float 0.))) "near" None c.near

let given () =
  let c =
    read
      "(perspective (eye 1 2 3) (look-at 4 5 6) (up 0 0 2) (fov-y 1) (near 2))"
  in
  Alcotest.(check bool) "eye" true (Point.equal c.eye (Point.v 1. 2. 3.));
  Alcotest.(check bool)
    "look-at" true
    (Point.equal c.look_at (Point.v 4. 5. 6.));
  Alcotest.(check bool) "up" true (Vec.equal c.up (Vec.v 0. 0. 2.));
  Alcotest.(check (option (float 0.))) "near" (Some 2.) c.near

let along () =
  let messages up =
    messages
      (Printf.sprintf
         "(scene (camera (perspective (eye 0 0 0) (look-at 1 2 3) (up %s) \
          (fov-y 40))))"
         up)
  in
  let refused = [ "1:16 (perspective ...): up points along the view" ] in
  let check up expected =
    Alcotest.(check (list string)) up expected (messages up)
  in
  check "1 2 3" refused;
  check "-0x1p-500 -0x2p-500 -0x3p-500" refused;
  check "0x1p300 0x2p300 0x3p300" refused;
  check "1 2 3.0000000000000004" [];
  check "0x1p-900 0x2p-900 0x3.1p-900" []

let suite =
  ( "camera decoder",
    [
      case "each way to frame a picture is read" frames;
      case "up is +y and rays start at the eye unless told otherwise" defaults;
      case "eye, look-at, up and near are as written" given;
      case "up may not be along the view, whatever its length" along;
    ] )
