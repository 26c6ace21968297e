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
    (Orthographic_window { window });
  check (Printf.sprintf "(panorama %s)" view) Panorama

let defaults () =
  let c = read (Printf.sprintf "(perspective %s (fov-y 40))" view) in
  Alcotest.(check bool) "up" true (Vec.equal c.up (Vec.v 0. 1. 0.));
  Alcotest.(check (option (float 0.))) "near" None c.near;
  is "lens" true (Option.is_none c.lens);
  is "shutter" true (Camera.equal_shutter Camera.instant c.shutter);
  is "place" true
    (Place.equal c.place { file = "test.scene"; line = 1; column = 8 })

let lens () =
  let c =
    read
      (Printf.sprintf
         "(perspective %s (fov-y 9) (focus-distance 5) (aperture-radius 0))"
         view)
  in
  is "lens" true
    (Option.equal Camera.equal_lens (Some { radius = 0.; focus = 5. }) c.lens)

let shutter () =
  let check kind =
    let c = read (Printf.sprintf "(%s (shutter -1 .5))" kind) in
    is kind true (Camera.equal_shutter { opens = -1.; closes = 0.5 } c.shutter)
  in
  check ("perspective (fov-y 9) " ^ view);
  check ("orthographic (height 9) " ^ view);
  check ("panorama " ^ view)

let refused () =
  let refuses camera expected =
    errors camera expected
      (Printf.sprintf "(scene\n(camera (%s %s)))" camera view)
  in
  let perspective = "perspective (fov-y 9) " in
  refuses
    (perspective ^ "(aperture-radius 1)")
    [ "2:9 (perspective ...): give (focus-distance D) with aperture-radius" ];
  refuses
    (perspective ^ "(focus-distance 1)")
    [ "2:9 (perspective ...): give (aperture-radius R) with focus-distance" ];
  refuses
    (perspective ^ "(aperture-radius -1) (focus-distance 0)")
    [
      "2:49 (aperture-radius ...) must not be negative, but is `-1`";
      "2:69 (focus-distance ...) must be above 0, but is `0`";
    ];
  refuses
    (perspective ^ "(shutter 1 0)")
    [ "2:32 (shutter ...): T0 must not be above T1" ];
  refuses
    (perspective ^ "(shutter 1)")
    [ "2:32 expected (shutter T0 T1), found 1 word" ];
  refuses "orthographic (height 1) (aperture-radius 1) (focus-distance 1)"
    [
      "2:34 unknown field `aperture-radius` in (orthographic ...)";
      "2:54 unknown field `focus-distance` in (orthographic ...)";
    ];
  refuses "panorama (fov-y 40) (near 1)"
    [
      "2:19 unknown field `fov-y` in (panorama ...)";
      "2:30 unknown field `near` in (panorama ...)";
    ]

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
      case "a lens has a radius, 0 too, and a distance in focus" lens;
      case "any camera has a shutter" shutter;
      case "what no camera has is told" refused;
      case "up may not be along the view, whatever its length" along;
    ] )
