(* Pictures of a coarse mesh that stands for a ball. *)

open Candor_space
open Candor_surface
open Candor_oracle
open Candor_colour
open Candor_effect
open Candor_scene_made
open Candor_image
open Candor_trace

let around = 8
let down = 5

let corner i j =
  let tilt = Float.pi *. float_of_int j /. float_of_int down
  and turn = 2. *. Float.pi *. float_of_int i /. float_of_int around in
  (sin tilt *. cos turn, cos tilt, sin tilt *. sin turn)

let show (x, y, z) = Printf.sprintf "(%.17g %.17g %.17g)" x y z

let triangle ~smooth a b c =
  let corners = String.concat " " (List.map show [ a; b; c ]) in
  let normals = if smooth then "(normals " ^ corners ^ ")" else "" in
  Printf.sprintf "(triangle %s %s)" corners normals

(** The mesh of the unit ball: 64 triangles. *)
let ball ?(smooth = true) material =
  let cell k =
    let i = k mod around and j = k / around in
    let a = corner i j and b = corner (i + 1) j in
    let c = corner i (j + 1) and d = corner (i + 1) (j + 1) in
    (if j > 0 then [ triangle ~smooth a b c ] else [])
    @ if j < down - 1 then [ triangle ~smooth b d c ] else []
  in
  let cells = List.concat_map cell (List.init (around * down) Fun.id) in
  Printf.sprintf "(group (material (%s)) %s)" material
    (String.concat "\n" cells)

let size = 60
let chalk = "matte (color 1)"

let view ?(size = size) ?(spp = 1) forms =
  Written.scene
    ([
       Written.size size size;
       Printf.sprintf "(render (spp %d))" spp;
       "(camera (orthographic (eye 0 0 5) (look-at 0 0 0) (height 2)))";
     ]
    @ forms)

(* Towards the light. *)
let lx, ly, lz = (2. /. 3., 1. /. 3., 2. /. 3.)
let sun = "(light (directional (direction -2 -1 -2) (irradiance 3)))"
let far_lamp = "(light (point (at 200 100 200) (intensity 270000)))"

(* A disk that shines like the sun, as seen from the ball. *)
let far_ball =
  "(sphere (center 200 100 200) (radius 3) (material (emitter (radiance \
   9549.3))))"

(* For each pixel that shows the mesh: how the ball would be lit in the direction
   of what is seen, and how bright that is. *)
let lit forms =
  let pixel = Pixel.compile (view forms) in
  let one k =
    let x = k mod size and y = k / size in
    let ray = Pixel.ray pixel ~x ~y ~sample:0 in
    let lit (hit : _ Hit.t) =
      let out = Point.sub hit.point Point.origin in
      let cos = Vec.dot out (Vec.v lx ly lz) /. Vec.norm out in
      (cos, (Pixel.radiance pixel (Tally.make ()) ~x ~y).r)
    in
    Option.map lit (Surface.nearest (Pixel.surface pixel) ray)
  in
  List.filter_map one (List.init (size * size) Fun.id)

(* Of irradiance 3 a white ball makes 3cos/π. *)
let like_a_ball light () =
  let seen = lit [ ball chalk; light ] in
  Alcotest.(check bool) "much is seen" true (List.length seen > 2000);
  List.iter
    (fun (cos, r) ->
      let expected = 3. /. Float.pi *. Float.max 0. cos in
      if Float.abs (r -. expected) > 0.08 then
        Alcotest.failf "where the cosine is %.3f: %.3f, not %.3f" cos r expected;
      if cos > 0.08 && not (r > 0.) then
        Alcotest.failf "black where the cosine is %.3f" cos;
      if cos < -0.08 && r > 0. then
        Alcotest.failf "%.3f where the cosine is %.3f" r cos)
    seen

(* Along a line across the terminator in the picture, it only gets darker. *)
let monotone light () =
  let s = view ~size:400 [ ball chalk; light ] in
  let pixel = Pixel.compile s in
  let at step =
    let far = float_of_int step /. 200. in
    let x = int_of_float (200. *. (1. +. (far *. 0.8)))
    and y = int_of_float (200. *. (1. -. (far *. 0.4))) in
    (Pixel.radiance pixel (Tally.make ()) ~x ~y).r
  in
  let rec go step before =
    if step > -180 then (
      let r = at step in
      if r > before then
        Alcotest.failf "at step %d it is %.4f after %.4f" step r before;
      go (step - 1) r)
    else before
  in
  let start = at 60 in
  if not (start > 0.8) then Alcotest.failf "%.3f to begin with" start;
  if go 59 start > 0. then Alcotest.fail "it does not get dark"

(* From behind, nothing comes through. *)
let no_leak () =
  let behind =
    [
      ball chalk;
      "(light (directional (direction 0 0 1) (irradiance 3)))";
      "(light (point (at 0 0 -3) (intensity 30)))";
      "(light (point (at 0 0 0) (intensity 30)))";
    ]
  in
  Alcotest.(check bool)
    "black" true
    (List.for_all
       (fun (c : Rgb.t) -> c.r < 0.35)
       (Measured.pixels (view behind)));
  let inner = Picture.pixel (Shot.picture (view behind)) 30 30 in
  Alcotest.(check (float 0.)) "black in the middle" 0. inner.r

(* Another surface still throws its shadow on it. *)
let shaded () =
  let s = view [ ball chalk; sun; "(box (min 3 -9 3) (max 9 9 9))" ] in
  Alcotest.(check bool)
    "black" true
    (List.for_all Rgb.is_black (Measured.pixels s))

(* All around the same: a furnace, that no more than white comes out of. *)
let furnace indirect_sky () =
  let s =
    Measured.scene ~spp:64
      [
        "(camera (orthographic (eye .21 .33 5) (look-at .21 .33 0) (height \
         1e-6)))";
        "(indirect-light)";
        "(background 1)";
        ball "matte (color .8)";
      ]
  in
  let s = indirect_sky s in
  let m = Measured.v s in
  Measured.sharp "the furnace" m;
  Measured.are "the furnace" m 0.8 0.8 0.8

let as_a_picture (s : Candor_scene.Scene.t) =
  let texels =
    Candor_scene.Texels.init ~width:8 ~height:4 (fun _ _ -> Rgb.white)
  in
  { s with background = Image { file = "white"; texels } }

let scaled () =
  List.iter
    (fun light ->
      let s = view ~size:24 [ ball chalk; light ] in
      Measured.not_black "the mesh" s;
      Measured.same "another scale" s (Scaled.by 0x1p-9 s))
    [ sun; far_lamp; far_ball ]

(* The inner side is hollow: seen from the middle, by a lamp there. *)
let hollow () =
  let s smooth =
    Written.scene
      [
        Written.size 24 12;
        Written.plain;
        "(camera (panorama (eye .1 0 0) (look-at 0 0 -1)))";
        "(light (point (at .1 .2 0) (intensity 1)))";
        ball ~smooth chalk;
      ]
  in
  Alcotest.(check bool)
    "lit all around" true
    (List.for_all (fun (c : Rgb.t) -> c.r > 0.1) (Measured.pixels (s true)))

let glass () =
  let s smooth =
    Measured.v
      (Measured.scene ~spp:16
         [
           Measured.needle;
           "(indirect-light)";
           "(background 1)";
           ball ~smooth "glass (index 1.5)";
         ])
  in
  Measured.are "smooth glass" (s true) 1. 1. 1.

let suite =
  ( "smooth mesh",
    [
      Law.example "a sun lights it like a ball" (like_a_ball sun);
      Law.example "so does a lamp" (like_a_ball far_lamp);
      Law.example "so does an area light" (like_a_ball far_ball);
      Law.example "towards the dark side it only gets darker" (monotone sun);
      Law.example "under a lamp, too" (monotone far_lamp);
      Law.example "no light leaks through" no_leak;
      Law.example "others throw shadows on it" shaded;
      Law.example "a furnace" (furnace Fun.id);
      Law.example "a furnace of a picture" (furnace as_a_picture);
      Law.example "a power of two leaves the bits" scaled;
      Law.example "it is lit from inside" hollow;
      Law.example "smooth glass loses nothing" glass;
    ] )
