open Candor_colour
open Candor_effect
open Candor_image
open Candor_oracle
open Candor_scene_made

let rgb = Alcotest.testable (Fmt.of_to_string Rgb.show) Rgb.equal

let shot ?(size = (64, 48)) ?(settings = "") forms =
  let settings = Printf.sprintf "(render (spp 1) %s)" settings in
  Shot.v
    (Written.scene (Written.size (fst size) (snd size) :: settings :: forms))

let pixels { Shot.picture; _ } f =
  for y = 0 to Picture.height picture - 1 do
    for x = 0 to Picture.width picture - 1 do
      f x y (Picture.pixel picture x y)
    done
  done

(* Looks down the z axis; shows -3 .. 3 by -3 .. 3 in 96 x 96 pixels. *)
let down = "(camera (orthographic (eye 0 0 9) (look-at 0 0 0) (height 6)))"
let square = (96, 96)
let place i = ((float_of_int i +. 0.5) /. 16.) -. 3.
let at x y = (place x, -.place y)

(* [to_the_bit s f] is whether the PFM of [s] is that of the closed form [f] of a
   point of the picture's plane. *)
let to_the_bit name shot f =
  let { Shot.picture; _ } = shot in
  let closed =
    Picture.init ~width:96 ~height:96 (fun x y ->
        let u, v = at x y in
        f u v)
  in
  if not (String.equal (Pfm.encode picture) (Pfm.encode closed)) then
    pixels shot (fun x y c ->
        let d = Picture.pixel closed x y in
        if Int32.bits_of_float c.r <> Int32.bits_of_float d.r then
          Alcotest.failf "%s: pixel %d %d is %h, not %h" name x y c.r d.r)

let background () =
  let s = shot [ Written.wide_camera; "(background (rgb .1 .2 .3))" ] in
  pixels s (fun _ _ c -> Alcotest.check rgb "everywhere" (Rgb.v 0.1 0.2 0.3) c);
  Alcotest.(check int) "camera rays" (64 * 48) (Tally.get s.tally Camera_rays);
  Alcotest.(check (list int))
    "no others"
    [ 64 * 48 ]
    (List.filter (fun n -> n > 0) (List.map (Tally.get s.tally) Tally.rays))

let silhouette () =
  let s =
    shot ~size:square
      [
        down;
        "(background 1)";
        "(sphere (center .3 -.2 0) (radius 2) (material (matte (color 0))))";
      ]
  in
  let inside = ref 0 in
  pixels s (fun x y c ->
      let u, v = at x y in
      let d2 = ((u -. 0.3) ** 2.) +. ((v +. 0.2) ** 2.) in
      Alcotest.(check (float 0.))
        (Printf.sprintf "pixel %d %d" x y)
        (if d2 < 4. then 0. else 1.)
        c.g;
      if c.g = 0. then incr inside);
  let area = float_of_int !inside /. 256. in
  if Float.abs (area -. (4. *. Float.pi)) > 0.005 *. 4. *. Float.pi then
    Alcotest.failf "the area is %g, not 4 pi" area

let floor_of material =
  Printf.sprintf "(box (min -9 -9 0) (max 9 9 0) (material %s))" material

let matte = floor_of "(matte (color (rgb .8 .5 .1)))"
let albedo = Rgb.v 0.8 0.5 0.1

let lambert () =
  to_the_bit "facing a directional light"
    (shot ~size:square
       [
         down;
         matte;
         "(light (directional (direction 0 0 -1) (irradiance 3.5)))";
       ])
    (fun _ _ -> Rgb.scale (3.5 /. Float.pi) albedo);
  to_the_bit "at an angle whose cosine is 3/5"
    (shot ~size:square
       [
         down; matte; "(light (directional (direction 4 0 -3) (irradiance 2)))";
       ])
    (fun _ _ -> Rgb.scale (2. *. 0.6 /. Float.pi) albedo);
  to_the_bit "under a point light"
    (shot ~size:square
       [ down; matte; "(light (point (at .5 1 2) (intensity 7)))" ])
    (fun u v ->
      let r2 = ((u -. 0.5) ** 2.) +. ((v -. 1.) ** 2.) +. 4. in
      Rgb.scale (7. *. 2. /. sqrt r2 /. r2 /. Float.pi) albedo);
  to_the_bit "under a point light without falloff"
    (shot ~size:square
       [
         down; matte; "(light (point (at .5 1 2) (intensity 7) (falloff none)))";
       ])
    (fun u v ->
      let r2 = ((u -. 0.5) ** 2.) +. ((v -. 1.) ** 2.) +. 4. in
      Rgb.scale (7. *. 2. /. sqrt r2 /. Float.pi) albedo)

(* The same plane as every surface that can be flat there. *)
let flat_surfaces () =
  let light = "(light (point (at .5 1 2) (intensity 7)))" in
  let m = "(material (matte (color (rgb .8 .5 .1))))" in
  let reference = shot ~size:square [ down; matte; light ] in
  List.iter
    (fun surface ->
      let s = shot ~size:square [ down; light; surface ^ m ^ ")" ] in
      pixels s (fun x y c ->
          let d = Picture.pixel reference.picture x y in
          if Float.abs (c.r -. d.r) > 1e-13 then
            Alcotest.failf "%s, pixel %d %d: %g, not %g" surface x y c.r d.r))
    [
      "(quadric (plane (normal 0 0 1) (offset 0))";
      "(quadric (plane (normal 0 0 -2) (offset 0))";
      "(triangle (-20 -20 0) (20 -20 0) (0 40 0)";
      "(polygon (-9 -9 0) (9 -9 0) (9 9 0) (-9 9 0)";
      "(box (min -9 -9 -1) (max 9 9 0)";
      "(quadric (matrix 0 0 0 0  0 0 0 0  0 0 0 1  0 0 1 0)";
      "(quadric (form (a 0 0 0 0 0 0 0 0 0) (b 0 0 -1) (c 0))";
      "(quadric (cylinder (from 0 0 -1) (to 0 0 0) (radius 20)) (caps)";
      "(group (transform (rotate (axis 1 0 0) (degrees 90))) (quadric (plane \
       (normal 0 1 0) (offset 0)))";
    ]

let mirror () =
  let forms m = [ down; floor_of m; "(background (rgb .25 .5 1))" ] in
  to_the_bit "a mirror of a uniform sky"
    (shot ~size:square (forms "(mirror (color (rgb .5 .75 .125)))"))
    (fun _ _ -> Rgb.v 0.125 0.375 0.125);
  to_the_bit "a glaze of it"
    (shot ~size:square (forms "(glazed (color 0) (mirror (rgb .5 .75 .125)))"))
    (fun _ _ -> Rgb.v 0.125 0.375 0.125);
  (* A mirror at 45 degrees shows straight up: the gradient's end. *)
  let s =
    shot
      [
        Written.flat_camera;
        "(quadric (plane (normal 0 1 1) (offset 0)) (material (mirror (color \
         .5))))";
        "(background (gradient (down (rgb 1 0 0)) (up (rgb 0 0 1))))";
      ]
  in
  pixels s (fun _ _ c -> Alcotest.check rgb "straight up" (Rgb.v 0. 0. 0.5) c)

(* Two glazed floors face each other; each hit adds a = color·ambient, and what is
   beyond counts M times. *)
let facing depth =
  shot ~size:(2, 2)
    ~settings:(Printf.sprintf "(depth %d)" depth)
    [
      "(camera (orthographic (eye 0 0 1) (look-at 0 0 0) (height 2)))";
      "(ambient (rgb .5 1 .25))";
      floor_of "(glazed (color .5) (mirror .25))";
      "(box (min -9 -9 2) (max 9 9 2) (material (glazed (color .5) (mirror \
       .25))))";
    ]

let depths () =
  let sum depth =
    List.fold_left
      (fun s k -> s +. (0.25 ** float_of_int k))
      0.
      (List.init (depth + 1) Fun.id)
  in
  List.iter
    (fun depth ->
      let s = facing depth in
      pixels s (fun _ _ c ->
          Alcotest.check rgb
            (Printf.sprintf "depth %d" depth)
            (Rgb.scale (sum depth) (Rgb.v 0.25 0.5 0.125))
            c);
      Alcotest.(check (pair int int))
        "rays and cuts"
        (4 * depth, 4)
        (Tally.get s.tally Mirror_rays, Tally.get s.tally Cut_by_depth))
    [ 0; 1; 2; 5; 12 ]

(* Between two mirrors a ray that advances 1 aside per crossing leaves after a
   known number of reflections. *)
let escapes () =
  let value depth =
    let s =
      shot ~size:(1, 1)
        ~settings:(Printf.sprintf "(depth %d)" depth)
        [
          "(camera (orthographic (eye -1 0 1) (look-at 0 0 0) (height .01)))";
          "(background 1)";
          "(box (min -9 -9 0) (max 3.5 9 0) (material (mirror (color .5))))";
          "(box (min -9 -9 1.5) (max 3.5 9 1.5) (material (mirror (color .5))))";
        ]
    in
    (Picture.pixel s.picture 0 0).r
  in
  (* Down at x = 0, up at 1.5, down at 3, and out. *)
  List.iter
    (fun (depth, expected) ->
      Alcotest.(check (float 0.))
        (Printf.sprintf "depth %d" depth)
        expected (value depth))
    [ (0, 0.); (1, 0.); (2, 0.); (3, 0.125); (4, 0.125); (8, 0.125) ]

let cutoff () =
  let value w =
    let s =
      shot ~size:(1, 1)
        ~settings:(Printf.sprintf "(depth 20) (cutoff %g)" w)
        [
          "(camera (orthographic (eye 0 0 1) (look-at 0 0 0) (height 2)))";
          "(ambient 1)";
          floor_of "(glazed (color .5) (mirror .5))";
          "(box (min -9 -9 2) (max 9 9 2) (material (glazed (color .5) (mirror \
           .5))))";
        ]
    in
    ((Picture.pixel s.picture 0 0).r, Tally.get s.tally Cut_by_weight)
  in
  let check w expected =
    Alcotest.(check (pair (float 0.) int))
      (Printf.sprintf "cutoff %g" w)
      (expected, 1) (value w)
  in
  check 0.6 0.5;
  check 0.5 0.75;
  check 0.26 0.75;
  check 0.125 (0.5 *. 1.875)

let glazed () =
  to_the_bit "ambient + diffuse + M times the mirror"
    (shot ~size:square
       [
         down;
         floor_of "(glazed (color (rgb .8 .5 .1)) (mirror .25))";
         "(background (rgb .25 .5 1))";
         "(ambient .5)";
         "(light (directional (direction 0 0 -1) (irradiance 2)))";
       ])
    (fun _ _ ->
      Rgb.add
        (Rgb.add (Rgb.scale 0.5 albedo) (Rgb.scale (2. /. Float.pi) albedo))
        (Rgb.v 0.0625 0.125 0.25))

(* The light at height 4, a ball of radius 1/2 at height 2: its shadow is a disk
   of radius 4·tan(asin(1/4)). *)
let shadow () =
  let radius = 4. *. tan (asin 0.25) in
  let forms shadows =
    [
      down;
      matte;
      "(sphere (center 0 0 2) (radius .5) (material (matte (color 0))))";
      "(light (point (at 0 0 4) (intensity 7) " ^ shadows ^ "))";
    ]
  in
  let lit u v =
    let r2 = (u *. u) +. (v *. v) +. 16. in
    Rgb.scale (7. *. 4. /. sqrt r2 /. r2 /. Float.pi) albedo
  in
  let distance u v = sqrt ((u *. u) +. (v *. v)) in
  to_the_bit "a hard shadow"
    (shot ~size:square (forms ""))
    (fun u v -> if distance u v < radius then Rgb.black else lit u v);
  to_the_bit "no shadow, where none is wanted"
    (shot ~size:square (forms "(shadows no)"))
    (fun u v -> if distance u v < 0.5 then Rgb.black else lit u v)

let spot_circle () =
  (* A hard-edged spot at height 4 of half-angle 30 degrees. *)
  let s =
    shot ~size:square
      [
        down;
        matte;
        "(light (spot (at 0 0 4) (toward 0 0 0) (intensity 1) (inner 30) \
         (outer 30)))";
      ]
  in
  let radius = 4. *. tan (Float.pi /. 6.) in
  pixels s (fun x y c ->
      let u, v = at x y in
      Alcotest.(check bool)
        (Printf.sprintf "pixel %d %d" x y)
        (sqrt ((u *. u) +. (v *. v)) < radius)
        (c.r > 0.))

let checkered () =
  let s =
    shot ~size:square
      [ down; "(ambient 1)"; floor_of "(matte (color (checker 1 0)))" ]
  in
  pixels s (fun x y c ->
      let u, v = at x y in
      let even =
        (int_of_float (Float.floor u) + int_of_float (Float.floor v)) land 1 = 0
      in
      Alcotest.(check (float 0.))
        (Printf.sprintf "pixel %d %d" x y)
        (if even then 1. else 0.)
        c.r)

(* Red at the top left, green at the top right, blue at the bottom left. *)
let corners camera =
  let s =
    shot ~size:(8, 6)
      [
        camera;
        "(ambient 1)";
        "(sphere (center -4 3 0) (radius 1) (material (matte (color (rgb 1 0 \
         0)))))";
        "(sphere (center 4 3 0) (radius 1) (material (matte (color (rgb 0 1 \
         0)))))";
        "(sphere (center -4 -3 0) (radius 1) (material (matte (color (rgb 0 0 \
         1)))))";
      ]
  in
  let check name expected x y =
    Alcotest.check rgb
      (camera ^ ", " ^ name)
      expected
      (Picture.pixel s.picture x y)
  in
  check "top left" (Rgb.v 1. 0. 0.) 0 0;
  check "top right" (Rgb.v 0. 1. 0.) 7 0;
  check "bottom left" (Rgb.v 0. 0. 1.) 0 5;
  check "bottom right" Rgb.black 7 5;
  check "the middle" Rgb.black 4 3

let right_way_up () =
  List.iter corners
    [
      "(camera (orthographic (eye 0 0 5) (look-at 0 0 0) (window -4 4 -3 3)))";
      "(camera (orthographic (eye 0 0 5) (look-at 0 0 0) (height 6)))";
      "(camera (perspective (eye 0 0 5) (look-at 0 0 0) (window -4 4 -3 3) \
       (distance 5)))";
      Printf.sprintf
        "(camera (perspective (eye 0 0 5) (look-at 0 0 0) (fov-y %.17g)))"
        (2. *. atan 0.6 *. 180. /. Float.pi);
    ]

let off_centre () =
  let s =
    shot ~size:(8, 6)
      [
        "(camera (orthographic (eye 0 0 5) (look-at 0 0 0) (window 0 8 0 6)))";
        "(ambient 1)";
        "(sphere (center .5 .5 0) (radius .4))";
      ]
  in
  pixels s (fun x y c ->
      Alcotest.(check bool)
        (Printf.sprintf "pixel %d %d" x y)
        (x = 0 && y = 5)
        (c.r > 0.))

let near_plane () =
  let picture near =
    shot ~size:(9, 9)
      [
        Printf.sprintf
          "(camera (orthographic (eye 0 0 5) (look-at 0 0 0) (height 2) %s))"
          near;
        "(ambient 1)";
        "(sphere (center 0 0 4) (radius .5) (material (matte (color .25))))";
        floor_of "(matte (color 1))";
      ]
  in
  let middle s = (Picture.pixel s.Shot.picture 4 4).r in
  Alcotest.(check (float 0.)) "the ball" 0.25 (middle (picture ""));
  Alcotest.(check (float 0.))
    "cut open: its far side" 0.25
    (middle (picture "(near 1)"));
  Alcotest.(check (float 0.))
    "the plane is beyond it" 1.
    (middle (picture "(near 2)"))

let suite =
  ( "pictures in closed form",
    [
      Law.example "background only" background;
      Law.example "a ball's silhouette has area pi r^2 and the right pixels"
        silhouette;
      Law.example "Lambert's law on a plane, to the last bit of a PFM" lambert;
      Law.example "every flat surface shades like every other" flat_surfaces;
      Law.example "a mirror shows a known colour" mirror;
      Law.example "two facing mirrors at depths 0, 1, 2, 5, 12" depths;
      Law.example "a path that leaves two mirrors after three reflections"
        escapes;
      Law.example "paths end below the cut-off" cutoff;
      Law.example "glazed is ambient + diffuse + M times the mirror" glazed;
      Law.example "the hard shadow of a ball on a plane" shadow;
      Law.example "the circle of a spot light" spot_circle;
      Law.example "a checker floor" checkered;
      Law.example "the corners of a picture are the right way up" right_way_up;
      Law.example "a window off the axis" off_centre;
      Law.example "rays start on the near plane" near_plane;
    ] )
