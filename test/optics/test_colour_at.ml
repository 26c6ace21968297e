open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene
open Candor_optics
open Candor_oracle
open QCheck2

let local ?(flat = false) ?(normal = Dir.z) x y z : Local.t =
  {
    Candor_scene_made.Drawn.some_point with
    point = Point.v x y z;
    normal;
    flat;
  }

let plain k = Texture.Constant (Rgb.grey k)
let checker ?(scale = 1.) even odd = Texture.Checker { even; odd; scale }
let board ?scale () = checker ?scale (plain 0.) (plain 1.)
let is_odd texture local = (Colour_at.v texture local).r = 1.

let check name expected texture local =
  Alcotest.(check bool) name expected (is_odd texture local)

let constant =
  Law.law ~print:Draw.show_point "a constant colour is the same everywhere"
    (Draw.point Draw.coordinate) (fun p ->
      Rgb.equal (Colour_at.v (plain 0.3) (local p.x p.y p.z)) (Rgb.grey 0.3))

let cells () =
  let b = board () in
  check "the first cell" false b (local 0.5 0.5 0.5);
  check "the next in x" true b (local 1.5 0.5 0.5);
  check "the next in y" true b (local 0.5 1.5 0.5);
  check "the next in z" true b (local 0.5 0.5 1.5);
  check "two on" false b (local 1.5 1.5 0.5);
  check "three on" true b (local 1.5 1.5 1.5);
  check "below 0 in x" true b (local (-0.5) 0.5 0.5);
  check "below 0 in x and y" false b (local (-0.5) (-0.5) 0.5);
  check "two below 0" false b (local (-1.5) 0.5 0.5);
  check "just below 0" true b (local (-5e-324) 0.5 0.5);
  check "at 0" false b (local 0. 0. 0.);
  check "at minus 0" false b (local (-0.) 0. 0.);
  check "at 1" true b (local 1. 0. 0.);
  check "just below 1" false b (local (Float.pred 1.) 0. 0.);
  check "far away, even" false b (local 0x1p60 0. 0.);
  check "far away, odd" true b (local (0x1p52 +. 1.) 0. 0.);
  check "far below 0, odd" true b (local (-0x1p52 -. 1.) 0. 0.)

let scales () =
  check "half a unit" true (board ~scale:0.5 ()) (local 0.6 0. 0.);
  check "two units" false (board ~scale:2. ()) (local 1.9 0. 0.);
  check "two units, next" true (board ~scale:2. ()) (local 2.1 0. 0.)

let nested () =
  let t = checker ~scale:10. (board ()) (plain 1.) in
  check "the pattern within" true t (local 1.5 0.5 0.5);
  check "the pattern within, even" false t (local 0.5 0.5 0.5);
  check "beside it" true t (local 10.5 0.5 0.5)

(* ⌊x/S⌋ + ⌊y/S⌋ + ⌊z/S⌋ in whole numbers. *)
let parity ~skip scale (p : Point.t) =
  let cell x = int_of_float (Float.floor (x /. scale)) in
  let sum =
    List.fold_left
      (fun sum i -> if i = skip then sum else sum + cell (Point.get p i))
      0 [ 0; 1; 2 ]
  in
  sum land 1 = 1

let points =
  Gen.pair
    (Draw.point (Draw.uniform (-50.) 50.))
    (Draw.pick [ 1.; 0.25; 0.3; 7. ])

let show (p, s) = Printf.sprintf "%s scale %g" (Draw.show_point p) s

let formula =
  Law.law ~print:show "curved surfaces: even and odd by the formula" points
    (fun (p, scale) ->
      is_odd (board ~scale ()) (local p.x p.y p.z) = parity ~skip:3 scale p)

let directions =
  [
    (0, Vec.v 1. 0. 0.);
    (0, Vec.v (-3.) 1. 2.);
    (1, Vec.v 0. (-1.) 0.);
    (1, Vec.v 1. 2. (-1.9));
    (2, Vec.v 0. 0. 1.);
    (2, Vec.v 0.5 0.5 (-0.6));
  ]

let flats =
  Law.law ~print:show
    "flat surfaces leave out the axis their normal is largest in" points
    (fun (p, scale) ->
      List.for_all
        (fun (skip, n) ->
          let normal = Dir.of_vec_or Dir.x n in
          is_odd (board ~scale ()) (local ~flat:true ~normal p.x p.y p.z)
          = parity ~skip scale p)
        directions)

(* A floor at y = 0, where rounding would put every other point below 0. *)
let floor () =
  let s =
    Candor_scene_made.Written.scene
      [
        Candor_scene_made.Written.flat_camera;
        "(quadric (plane (normal 0 1 0) (offset 0)))";
        "(box (min -9 -9 8) (max 9 9 8))";
        "(triangle (20 0 0) (30 0 0) (20 0 10))";
      ]
  in
  let surface = Assembly.surface ~dress:Fun.id s in
  let color o d =
    match Surface.nearest surface (Ray.v o d) with
    | None -> Alcotest.fail "no hit"
    | Some h -> is_odd (board ()) h.local
  in
  for i = -6 to 6 do
    let x = float_of_int i +. 0.37 in
    let down x = color (Point.v x 0.7 0.3) (Vec.v 0. (-0.3) 0.) in
    Alcotest.(check bool)
      (Printf.sprintf "the plane at %g" x)
      (i land 1 = 1)
      (down x);
    Alcotest.(check bool)
      (Printf.sprintf "the flat box at %g" x)
      (i land 1 = 1)
      (color (Point.v x 0.7 9.) (Vec.v 0. 0. (-0.3)))
  done;
  Alcotest.(check bool)
    "the triangle" true
    (color (Point.v 21.3 0.7 0.3) (Vec.v 0. (-1.) 0.))

(* {1 Pictures and noise} *)

let texels =
  Texels.init ~width:5 ~height:3 (fun x y ->
      Rgb.v (float_of_int x) (float_of_int y) (float_of_int ((x * y) + 1)))

let picture = Texture.Image { file = "texels"; texels }

let met form o d =
  let s =
    Candor_scene_made.Written.scene
      [ Candor_scene_made.Written.flat_camera; form ]
  in
  match Surface.nearest (Assembly.surface ~dress:Fun.id s) (Ray.v o d) with
  | None -> Alcotest.failf "%s is not met" form
  | Some h -> h.local

let down = Vec.v 0. 0. (-1.)

(* Where each kind of surface says that its picture goes. *)
let pictures () =
  let check form o d (u, v) =
    Near.rgb ~within:1e-12 form
      (Texels.bilinear_repeating texels ~u ~v)
      (Colour_at.v picture (met form o d))
  in
  let turn y x = 0.5 +. (atan2 y x /. (2. *. Float.pi)) in
  check "(sphere (center 1 2 3) (radius 5))" (Point.v 4. 2. 20.) down
    (turn 3. 4., 0.5);
  check "(sphere (center 1 2 3) (radius 5))" (Point.v 1. 5. 20.) down
    (turn 0. 4., 0.5 +. (asin 0.6 /. Float.pi));
  check "(box (min 0 0 0) (max 2 4 8))" (Point.v 0.5 3. 20.) down (0.25, 0.75);
  check "(box (min 0 0 0) (max 2 4 8))" (Point.v 20. 1. 6.) (Vec.v (-1.) 0. 0.)
    (0.25, 0.75);
  check "(triangle (0 0 0) (10 0 0) (0 10 0))" (Point.v 2. 3. 9.) down (0.2, 0.3);
  check "(triangle (0 0 0) (10 0 0) (0 10 0) (uv (1 1) (2 1) (1 3)))"
    (Point.v 2. 3. 9.) down (1.2, 1.6);
  check "(quadric (plane (normal 0 .1 1) (offset 0)))" (Point.v 1.3 0. 9.) down
    (1.3, 0.)

let mixes () =
  let scale = 0.3 in
  let noise =
    Texture.Noise
      { first = Constant Rgb.black; second = board (); scale; octaves = 3 }
  in
  let local =
    met "(sphere (center 0 0 0) (radius 2))" (Point.v 0.3 0.7 9.) down
  in
  let { Point.x; y; z } = local.point in
  let mix =
    Noise.mix ~octaves:3 (Point.v (x /. scale) (y /. scale) (z /. scale))
  in
  Near.rgb "noise"
    (Rgb.scale mix (Colour_at.v (board ()) local))
    (Colour_at.v noise local)

let suite =
  ( "colours at points",
    [
      constant;
      Law.example "checker cells, below 0 and on their borders too" cells;
      Law.example "checker scales" scales;
      Law.example "checkers within checkers" nested;
      formula;
      Law.example "pictures lie on surfaces by uv" pictures;
      Law.example "noise mixes two patterns" mixes;
      flats;
      Law.example "the floor, a flat box and a triangle show squares" floor;
    ] )
