open Candor_space
open Candor_colour
open Candor_scene
open Candor_oracle
open QCheck2

let value x y c = float_of_int ((((x * 7) + (y * 13) + (c * 5)) mod 32) + c)
let colour x y = Rgb.v (value x y 0) (value x y 1) (value x y 2)
let numbered width height = Texels.init ~width ~height colour

let rgb =
  Alcotest.testable
    (fun out c -> Format.pp_print_string out (Rgb.show c))
    Rgb.equal

let close (a : Rgb.t) (b : Rgb.t) =
  let close a b = Float.abs (a -. b) <= 1e-11 *. Float.max 1. (Float.abs b) in
  close a.r b.r && close a.g b.g && close a.b b.b

let check_close name expected found =
  if not (close found expected) then
    Alcotest.failf "%s: expected %s, found %s" name (Rgb.show expected)
      (Rgb.show found)

(* {1 The texels} *)

let kept () =
  let t = numbered 5 3 in
  Alcotest.(check (pair int int)) "size" (5, 3) (Texels.width t, Texels.height t);
  for x = 0 to 4 do
    for y = 0 to 2 do
      Alcotest.check rgb "texel" (colour x y) (Texels.get t x y)
    done
  done

let raises name f =
  match f () with
  | exception Invalid_argument _ -> ()
  | _ -> Alcotest.failf "%s: no Invalid_argument" name

let outside () =
  let t = numbered 5 3 in
  List.iter
    (fun (x, y) ->
      raises (Printf.sprintf "%d %d" x y) (fun () -> ignore (Texels.get t x y)))
    [ (-1, 0); (5, 0); (0, -1); (0, 3) ];
  List.iter
    (fun (w, h) -> raises "size" (fun () -> ignore (numbered w h)))
    [ (0, 1); (1, 0); (-1, 2) ]

let existence () =
  let t = numbered 5 3 in
  Alcotest.(check bool)
    "the last" true
    (Texels.exists (Rgb.equal (colour 4 2)) t);
  Alcotest.(check bool) "none" false (Texels.exists (fun c -> c.r < 0.) t)

(* {1 Between the centres} *)

(* The weight of a texel whose centre is so far away, of all its repetitions
   [period] apart. *)
let tent period x =
  let near n = Float.max 0. (1. -. Float.abs (x +. (n *. period))) in
  List.fold_left (fun sum n -> sum +. near n) 0. [ -2.; -1.; 0.; 1.; 2. ]

let weighted t weight =
  let sum = ref Rgb.black in
  for x = 0 to Texels.width t - 1 do
    for y = 0 to Texels.height t - 1 do
      sum := Rgb.add !sum (Rgb.scale (weight x y) (Texels.get t x y))
    done
  done;
  !sum

let centre i = float_of_int i +. 0.5

(* The sum of all texels by tents, repeated in both directions. *)
let repeated t ~u ~v =
  let w = float_of_int (Texels.width t)
  and h = float_of_int (Texels.height t) in
  weighted t (fun x y ->
      tent w ((u *. w) -. centre x) *. tent h (((1. -. v) *. h) -. centre y))

(* The same, with rows held at the borders. *)
let held t ~u ~v =
  let w = float_of_int (Texels.width t)
  and h = float_of_int (Texels.height t) in
  let y0 = Float.min (h -. 0.5) (Float.max 0.5 ((1. -. v) *. h)) in
  weighted t (fun x y ->
      tent w ((u *. w) -. centre x)
      *. Float.max 0. (1. -. Float.abs (y0 -. centre y)))

let size = Gen.oneof [ Gen.pure 1; Gen.pure 2; Gen.int_range 1 9 ]

let texels =
  let open Gen in
  let* width = size and* height = size in
  let value = oneof [ Draw.pick [ 0.; 1. ]; Draw.uniform 0. 1. ] in
  let+ values = array_size (pure (3 * width * height)) value in
  Texels.init ~width ~height (fun x y ->
      let at c = values.((3 * ((y * width) + x)) + c) in
      Rgb.v (at 0) (at 1) (at 2))

let lookup =
  Gen.triple texels
    (Draw.nudged (Draw.uniform 0. 1.))
    (Draw.nudged (Draw.uniform 0. 1.))

let show (t, u, v) = Printf.sprintf "%s at %h %h" (Texels.show t) u v

let by_tents (t, u, v) =
  close (Texels.bilinear_repeating t ~u ~v) (repeated t ~u ~v)

let exact () =
  let width = 8 and height = 4 in
  let t = numbered width height in
  for x = 0 to width - 1 do
    for y = 0 to height - 1 do
      let u = centre x /. 8. and v = 1. -. (centre y /. 4.) in
      List.iter
        (fun n ->
          Alcotest.check rgb "at a centre" (colour x y)
            (Texels.bilinear_repeating t ~u:(u +. n) ~v:(v -. n)))
        [ 0.; 1.; -1.; 0x1p40; -0x1p40 ]
    done
  done

let orientation () =
  let t = numbered 4 4 in
  let look = Texels.bilinear_repeating t in
  Alcotest.check rgb "top left" (colour 0 0) (look ~u:0.125 ~v:0.875);
  Alcotest.check rgb "top right" (colour 3 0) (look ~u:0.875 ~v:0.875);
  Alcotest.check rgb "bottom left" (colour 0 3) (look ~u:0.125 ~v:0.125);
  let mean a b = Rgb.scale 0.5 (Rgb.add a b) in
  Alcotest.check rgb "over the left border"
    (mean (colour 3 0) (colour 0 0))
    (look ~u:0. ~v:0.875);
  Alcotest.check rgb "over the top border"
    (mean (colour 1 3) (colour 1 0))
    (look ~u:0.375 ~v:1.)

let any_number =
  Gen.oneof
    [
      Draw.any_coordinate;
      Draw.signed (Draw.power (-1074) 1023);
      Draw.pick [ max_float; -.max_float; infinity; neg_infinity; nan ];
      Draw.pick [ -0.; -1e-20; Float.pred 1.; Float.pred 0. ];
    ]

let within (least : Rgb.t) (c : Rgb.t) (most : Rgb.t) =
  let within a b c = a <= b && b <= c in
  within least.r c.r most.r && within least.g c.g most.g
  && within least.b c.b most.b

let bounded (t, u, v) =
  within Rgb.black (Texels.bilinear_repeating t ~u ~v) Rgb.white

let anywhere = Gen.triple texels any_number any_number

let constant (c, u, v) =
  let c = Rgb.v c (3. *. c) (0.1 *. c) in
  let t = Texels.init ~width:3 ~height:2 (fun _ _ -> c) in
  Rgb.equal c (Texels.bilinear_repeating t ~u ~v)
  && Rgb.equal c (Texels.radiance t (Vec.v v 1. v))

(* {1 Around} *)

let straight =
  [
    ("ahead", Vec.v 0. 0. (-1.), 0.5, 0.5);
    ("right", Vec.v 1. 0. 0., 0.75, 0.5);
    ("left", Vec.v (-2.) 0. 0., 0.25, 0.5);
    ("behind, from the right", Vec.v 1e-300 0. 1., 1., 0.5);
    ("behind, from the left", Vec.v (-1e-300) 0. 1., 0., 0.5);
    ("up and ahead", Vec.v 0. 3. (-3.), 0.5, 0.75);
    ("down and ahead", Vec.v 0. (-3.) (-3.), 0.5, 0.25);
    ("up", Vec.v 0. 1. (-1e-300), 0.5, 1.);
    ("down", Vec.v 0. (-1.) (-1e-300), 0.5, 0.);
  ]

let places () =
  List.iter
    (fun (name, d, u, v) ->
      let found = Texels.towards d in
      Alcotest.(check (float 1e-15)) (name ^ ", u") u found.u;
      Alcotest.(check (float 1e-15)) (name ^ ", v") v found.v)
    straight

(* Eight columns, so that centres are seen at odd sixteenths of the turn. *)
let seen () =
  let t = numbered 8 4 in
  let look u v =
    let turn = 2. *. Float.pi *. (u -. 0.5) and rise = Float.pi *. (v -. 0.5) in
    let c = cos rise in
    Texels.radiance t (Vec.v (c *. sin turn) (sin rise) (-.c *. cos turn))
  in
  for x = 0 to 7 do
    for y = 0 to 3 do
      check_close
        (Printf.sprintf "texel %d %d" x y)
        (colour x y)
        (look (centre x /. 8.) (1. -. (centre y /. 4.)))
    done
  done;
  check_close "just above the last row's centre" (colour 2 3)
    (look (2.5 /. 8.) 0.02);
  check_close "just below the pole" (colour 2 0) (look (2.5 /. 8.) 0.98);
  check_close "behind"
    (Rgb.scale 0.5 (Rgb.add (colour 0 0) (colour 7 0)))
    (look 0. 0.875)

let directions = Gen.pair texels (Gen.bind Draw.unit Draw.stretched)

let show_direction (t, d) =
  Printf.sprintf "%s towards %s" (Texels.show t) (Draw.show_vec d)

let around (t, d) =
  let { Texels.u; v } = Texels.towards d in
  0. <= u && u <= 1. && 0. <= v && v <= 1.
  && close (Texels.radiance t d) (held t ~u ~v)

let lengths (t, d) =
  List.for_all
    (fun k ->
      Rgb.equal (Texels.radiance t d) (Texels.radiance t (Vec.scale k d)))
    [ 2.; 0x1p300; 0x1p-300 ]

(* {1 Equality} *)

let few =
  Gen.map3
    (fun width height k ->
      Texels.init ~width ~height (fun x y ->
          Rgb.grey (if k = x then -0. else float_of_int (y mod 2))))
    (Gen.int_range 1 2) (Gen.int_range 1 2) (Gen.int_range (-1) 1)

let changed c x y = if x = 1 && y = 1 then c else colour x y

let noticed () =
  let with_ c = Texels.init ~width:2 ~height:2 (changed c) in
  let { Rgb.r; g; b } = colour 1 1 in
  Derived.notices
    (module Texels)
    (with_ (Rgb.v r g b))
    [
      ("red", with_ (Rgb.v (r +. 1.) g b));
      ("green", with_ (Rgb.v r (Float.succ g) b));
      ("blue", with_ (Rgb.v r g (b -. 1.)));
      ("width", numbered 3 2);
      ("height", numbered 2 3);
    ]

let suite =
  ( "texels",
    [
      Law.example "what is put in comes out" kept;
      Law.example "there is nothing outside" outside;
      Law.example "exists asks every texel" existence;
      Law.law ~print:show "lookups are sums of tents over repeated texels"
        lookup by_tents;
      Law.example "lookups are exact at centres, in all repetitions" exact;
      Law.example "u goes right, v up, and both repeat" orientation;
      Law.law ~print:show "lookups of texels in [0;1] are in [0;1] anywhere"
        anywhere bounded;
      Law.law
        ~print:(fun (c, u, v) -> Printf.sprintf "%h at %h %h" c u v)
        "a constant picture has one colour, bit for bit"
        (Gen.triple (Draw.uniform 0. 10.) any_number (Draw.uniform (-9.) 9.))
        constant;
      Law.example "the centre is towards -z, the right half towards +x" places;
      Law.example "directions see the texels of an environment" seen;
      Law.law ~print:show_direction
        "radiance is a sum of tents, repeated around and held at the poles"
        directions around;
      Law.law ~print:show_direction "the length of a direction does not count"
        directions lengths;
      Law.example "each component and both sides count in equality" noticed;
    ]
    @ Derived.laws (module Texels) "texels" few )
