(* Pictures of skies, and by their light. *)

open Candor_space
open Candor_oracle
open Candor_colour
open Candor_scene
open Candor_scene_made
open Candor_image

let indirect = "(indirect-light)"

(* {1 Seen} *)

let width = 12
let height = 6

(* No two texels alike. *)
let texel x y =
  let x = float_of_int x and y = float_of_int y in
  Rgb.v (1. +. x) (1. +. (y *. y)) (0.5 +. (Float.rem (x *. 5.) 7. *. y))

let texels = Texels.init ~width ~height texel

let under texels (s : Scene.t) =
  { s with background = Image { file = "sky.pfm"; texels } }

let panorama ?(toward = "0 0 -1") () =
  Printf.sprintf "(camera (panorama (eye 3 1 2) (look-at %s)))" toward

let look ~size:(w, h) camera =
  under texels (Written.scene [ Written.size w h; Written.plain; camera ])

let near what (a : Rgb.t) (b : Rgb.t) =
  let near a b = Float.abs (a -. b) <= 1e-9 *. (1. +. Float.abs b) in
  if not (near a.r b.r && near a.g b.g && near a.b b.b) then
    Alcotest.failf "%s: expected %s, got %s" what (Rgb.show b) (Rgb.show a)

let each picture f =
  for y = 0 to Picture.height picture - 1 do
    for x = 0 to Picture.width picture - 1 do
      near
        (Printf.sprintf "pixel %d %d" x y)
        (Picture.pixel picture x y)
        (f x y)
    done
  done

(* Ahead is −z of the camera at (3, 1, 2) if it looks at (3, 1, 1). *)
let itself () =
  each
    (Shot.picture (look ~size:(width, height) (panorama ~toward:"3 1 1" ())))
    texel

(* With +x ahead, what was a quarter of a turn to the right is in the middle. *)
let turned () =
  each
    (Shot.picture (look ~size:(width, height) (panorama ~toward:"4 1 2" ())))
    (fun x y -> texel ((x + (width / 4)) mod width) y)

let camera toward up =
  Printf.sprintf
    "(camera (perspective (eye 0 0 0) (look-at %s) (up %s) (fov-y 1e-7)))"
    toward up

(* Between the centres of four texels. *)
let axes () =
  let seen toward up = Shot.pixel (look ~size:(1, 1) (camera toward up)) 0 0 in
  let mean x x' y y' =
    let sum = Rgb.add (Rgb.add (texel x y) (texel x' y)) in
    Rgb.scale 0.25 (sum (Rgb.add (texel x y') (texel x' y')))
  in
  near "−z" (seen "0 0 -1" "0 1 0") (mean 5 6 2 3);
  near "+x" (seen "1 0 0" "0 1 0") (mean 8 9 2 3);
  near "−x" (seen "-1 0 0" "0 1 0") (mean 2 3 2 3);
  near "+z" (seen "0 0 1" "0 1 0") (mean 11 0 2 3)

let poles () =
  let s = look ~size:(1, 1) (camera "0 1 0" "0 0 1") in
  let { Rgb.g; _ } = Shot.pixel s 0 0 in
  Alcotest.(check (float 1e-9)) "straight up" (texel 0 0).g g;
  let s = look ~size:(1, 1) (camera "0 -1 0" "0 0 1") in
  let { Rgb.g; _ } = Shot.pixel s 0 0 in
  Alcotest.(check (float 1e-9)) "straight down" (texel 0 (height - 1)).g g

(* {1 The panorama} *)

(* The part of the sphere of directions that shows a ball. *)
let solid_angle ball expected () =
  let w = 120 and h = 60 in
  let s =
    Written.scene
      [
        Written.size w h;
        "(render (spp 16))";
        "(camera (panorama (eye 0 0 0) (look-at 0 0 -1)))";
        ball;
      ]
  in
  let picture = Shot.picture s in
  let total = ref 0. in
  for y = 0 to h - 1 do
    let border y = cos (Float.pi *. float_of_int y /. float_of_int h) in
    let cell =
      2. *. Float.pi /. float_of_int w *. (border y -. border (y + 1))
    in
    for x = 0 to w - 1 do
      total := !total +. (cell *. (Picture.pixel picture x y).r)
    done
  done;
  if not (Float.abs (!total -. expected) <= 2e-3 *. expected) then
    Alcotest.failf "expected %.6f, got %.6f" expected !total

let shining center =
  Printf.sprintf
    "(sphere (center %s) (radius 1) (material (emitter (radiance 1))))" center

(* sin a = 1/2: 2π(1 − cos a). *)
let cap = 2. *. Float.pi *. (1. -. sqrt 0.75)

(* {1 As a light} *)

let needle = Measured.needle

let patch ?(color = "(rgb .6 .3 .9)") ?(turn = "0 1 0") () =
  Printf.sprintf
    "(quadric (plane (normal %s) (offset 0)) (material (matte (color %s))))"
    turn color

(* Looks down at an angle at a point of the floor. *)
let steep = "(camera (perspective (eye 0 3 4) (look-at 0 0 0) (fov-y 1e-6)))"

let uniform () =
  let s =
    Measured.scene ~spp:4 [ steep; indirect; "(background 2)"; patch () ]
  in
  Measured.are "a uniform sky" (Measured.v s) 1.2 0.6 1.8

(* The irradiance is π((down + up)/2 + (up − down)/3). *)
let gradient () =
  let s =
    Measured.scene ~spp:64
      [
        steep;
        indirect;
        "(background (gradient (down (rgb 1 0 3)) (up (rgb 2 5 0))))";
        patch ();
      ]
  in
  let one color down up =
    color *. (((down +. up) /. 2.) +. ((up -. down) /. 3.))
  in
  let m = Measured.v s in
  Measured.sharp "a gradient" m;
  Measured.are "a gradient" m (one 0.6 1. 2.) (one 0.3 0. 5.) (one 0.9 3. 0.)

(* A sky with a small sun, by sums over small parts of it. *)
let sunny =
  Texels.init ~width:32 ~height:16 (fun x y ->
      if x = 5 && y = 4 then Rgb.v 900. 600. 300.
      else Rgb.v 1. (float_of_int y /. 16.) 0.5)

let irradiance texels (normal : Vec.t) =
  let n = 512 and m = 256 in
  let sum = ref Rgb.black in
  for i = 0 to n - 1 do
    for j = 0 to m - 1 do
      let part k n = (float_of_int k +. 0.5) /. float_of_int n in
      let turn = 2. *. Float.pi *. part i n and down = Float.pi *. part j m in
      let d = Vec.v (sin down *. sin turn) (cos down) (sin down *. cos turn) in
      let angle =
        2. *. Float.pi /. float_of_int n
        *. (Float.pi /. float_of_int m)
        *. sin down
      in
      let cos = Float.max 0. (Vec.dot d normal) in
      sum := Rgb.add !sum (Rgb.scale (cos *. angle) (Texels.radiance texels d))
    done
  done;
  !sum

let under_a_sun ?(floor = patch ~color:"1" ()) ?(turn = Vec.v 0. 1. 0.) () =
  let s = under sunny (Measured.scene ~spp:256 [ steep; indirect; floor ]) in
  let m = Measured.v s in
  let e = Rgb.scale (1. /. Float.pi) (irradiance sunny turn) in
  Measured.sharp "a sunny sky" m;
  (* The sum over parts is good to a thousandth. *)
  let wider (x : Measured.t) (by : float) =
    { x with error = x.error +. (2e-4 *. by) }
  in
  Measured.are "a sunny sky"
    {
      red = wider m.red e.r;
      green = wider m.green e.g;
      blue = wider m.blue e.b;
    }
    e.r e.g e.b

let tilted () =
  under_a_sun
    ~floor:(patch ~color:"1" ~turn:"-3 4 0" ())
    ~turn:(Vec.v (-0.6) 0.8 0.) ()

let white = Texels.init ~width:8 ~height:4 (fun _ _ -> Rgb.white)

(* Under a picture that is the same everywhere, both ways of finding its light
   add up to one. *)
let furnace material expected () =
  let s =
    under white
      (Measured.scene ~spp:256
         [
           steep;
           indirect;
           "(sphere (center 0 0 0) (radius 1) " ^ material ^ ")";
         ])
  in
  let m = Measured.v s in
  Measured.sharp "the furnace" m;
  Measured.are "the furnace" m expected expected expected

(* Light from a picture in fog that absorbs nothing. *)
let misty () =
  let s =
    under white
      (Measured.scene ~spp:256
         [
           steep;
           indirect;
           "(sphere (center 0 0 0) (radius 1) (material (matte (color 1))))";
           "(fog (extinction (rgb .3 .6 1)) (albedo 1) (anisotropy .4) (within \
            (min -2 -2 -2) (max 2 2 2)))";
         ])
  in
  let m = Measured.v s in
  Measured.sharp "the mist" m;
  Measured.are "the mist" m 1. 1. 1.

let suite =
  ( "skies",
    [
      Law.example "a panorama of a sky is its picture" itself;
      Law.example "it turns with the camera" turned;
      Law.example "a sky's middle is ahead, +x to the right" axes;
      Law.example "its first row is up, its last down" poles;
      Law.example "a panorama shows a ball ahead in its solid angle"
        (solid_angle (shining "0 0 -2") cap);
      Law.example "across the seam, too" (solid_angle (shining "0 0 2") cap);
      Law.example "and at a pole" (solid_angle (shining "0 2 0") cap);
      Law.example "around the camera it is all" (fun () ->
          solid_angle
            "(sphere (center 0 0 0) (radius 1) (both-sides) (material (emitter \
             (radiance 1))))"
            (4. *. Float.pi) ());
      Law.example "a uniform sky lights a floor" uniform;
      Law.example "a gradient lights a floor" gradient;
      Law.example "a picture with a sun lights a floor" (fun () ->
          under_a_sun ());
      Law.example "a picture with a sun lights a slope" tilted;
      Law.example "a matte furnace in a white picture"
        (furnace "(material (matte (color .7)))" 0.7);
      Law.example "a mirror in a white picture"
        (furnace "(material (mirror (color .7)))" 0.7);
      Law.example "a glass ball in a white picture"
        (furnace "(material (glass (index 1.5)))" 1.);
      Law.example "white fog in a white picture" misty;
    ] )
