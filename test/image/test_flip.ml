open Candor_colour
open Candor_image
open Support
open QCheck2

(* {1 Pictures} *)

let display ~width ~height f =
  let made =
    Raster.init ~width ~height ~maxval:255 (fun x y c ->
        let r, g, b = f x y in
        let level = match c with 0 -> r | 1 -> g | _ -> b in
        Ok (level land 255))
  in
  match made with Ok r -> Picture_file.Display r | Error e -> Alcotest.fail e

let plaid x y = ((7 * x) + (3 * y), x * y, (5 * x) + (11 * y))
let shifted x y = ((7 * x) + (3 * y), (x * y) + 9, (5 * x) + (12 * y))
let flat r g b _ _ = (r, g, b)
let ramp x y = ((2 * x) + y, 3 * x, 255 - y)

let dots x y =
  let dot = if x mod 16 = 0 && y mod 16 = 0 then 40 else 0 in
  ((2 * x) + y + dot, 3 * x, 255 - y)

let flip ?(ppd = Flip.default_ppd) a b =
  match Flip.v ~ppd a b with Ok f -> f | Error e -> Alcotest.fail e

(* {1 What the authors' program says} *)

(* flip_evaluator 1.7; it computes in single precision, where rounding alone
   makes features of about 10^-4 in even pictures, and 2·10^-5 of the map. *)
let published name ~ppd ~width ~height f g ~mean ~first ~middle =
  let m = flip ~ppd (display ~width ~height f) (display ~width ~height g) in
  let check what = Alcotest.(check (float 3e-5)) (name ^ ": " ^ what) in
  check "mean" mean (Flip.mean m);
  check "first pixel" first (Flip.at m 0 0);
  check "middle pixel" middle (Flip.at m (width / 2) (height / 2))

let values () =
  let usual = Flip.default_ppd in
  let plaids = published "plaid" ~width:97 ~height:41 plaid shifted in
  plaids ~ppd:usual ~mean:0.3157390 ~first:0.099217 ~middle:0.206354;
  plaids ~ppd:20. ~mean:0.3790559 ~first:0.088985 ~middle:0.298846;
  plaids ~ppd:33.5 ~mean:0.3781775 ~first:0.089899 ~middle:0.276355;
  plaids ~ppd:150. ~mean:0.1840962 ~first:0.140679 ~middle:0.121397;
  published "dots" ~ppd:usual ~width:64 ~height:48 ramp dots ~mean:0.0027309
    ~first:0.061066 ~middle:0.000386;
  published "one row" ~ppd:usual ~width:50 ~height:1 plaid shifted
    ~mean:0.0488934 ~first:0.087589 ~middle:0.037595;
  published "many rows" ~ppd:usual ~width:5 ~height:600 plaid shifted
    ~mean:0.4898794 ~first:0.098805 ~middle:0.717423

let extremes () =
  let even name f g v =
    published name ~ppd:Flip.default_ppd ~width:16 ~height:16 f g ~mean:v
      ~first:v ~middle:v
  in
  even "black and white" (flat 0 0 0) (flat 255 255 255) 0.967388;
  even "green and blue" (flat 0 255 0) (flat 0 0 255) 1.;
  even "two greys" (flat 100 100 100) (flat 110 110 110) 0.153475

(* {1 Laws} *)

let pair_of picture =
  let open Gen in
  let* width = int_range 1 24 in
  let* height = int_range 1 24 in
  let* ppd = float_range 1. 90. in
  let half = picture ~width ~height in
  let+ a = half and+ b = half in
  (ppd, a, b)

let noise ~width ~height =
  let open Gen in
  let+ levels = array_size (pure (3 * width * height)) (int_bound 255) in
  Picture_file.Display (raster_of ~width ~height ~maxval:255 levels)

let radiance ~width ~height =
  let open Gen in
  let+ numbers = array_size (pure (3 * width * height)) number in
  Picture_file.Linear (picture_of ~width ~height numbers)

let either ~width ~height =
  Gen.oneof [ noise ~width ~height; radiance ~width ~height ]

let for_all holds m =
  let all n f = List.for_all f (List.init n Fun.id) in
  all (Flip.height m) (fun y -> all (Flip.width m) (fun x -> holds x y))

let same m n =
  for_all (fun x y -> Float.equal (Flip.at m x y) (Flip.at n x y)) m

let within (ppd, a, b) =
  let m = flip ~ppd a b in
  let unit v = v >= 0. && v <= 1. in
  unit (Flip.mean m) && for_all (fun x y -> unit (Flip.at m x y)) m

let nothing (ppd, a, _) =
  let m = flip ~ppd a a in
  Flip.mean m = 0. && for_all (fun x y -> Flip.at m x y = 0.) m

let symmetric (ppd, a, b) = same (flip ~ppd a b) (flip ~ppd b a)

let clamped = function
  | Picture_file.Display _ as d -> d
  | Linear p ->
      let clamp v = if v > 0. then Float.min 1. v else 0. in
      Linear
        (Picture.init ~width:(Picture.width p) ~height:(Picture.height p)
           (fun x y ->
             let { Rgb.r; g; b } = Picture.pixel p x y in
             Rgb.v (clamp r) (clamp g) (clamp b)))

let clamps (ppd, a, b) =
  same (flip ~ppd a b) (flip ~ppd (clamped a) (clamped b))

(* Levels drive an sRGB display, so light decoded by Display's power instead
   shows the same levels again. *)
let decoded (ppd, a, b) =
  let linear = function
    | Picture_file.Linear _ as l -> l
    | Display r ->
        let light x y c = Display.decode (Raster.sample r x y c) in
        Linear
          (Picture.init ~width:(Raster.width r) ~height:(Raster.height r)
             (fun x y -> Rgb.v (light x y 0) (light x y 1) (light x y 2)))
  in
  let m = flip ~ppd a b and n = flip ~ppd (linear a) (linear b) in
  for_all (fun x y -> Float.abs (Flip.at m x y -. Flip.at n x y) < 1e-5) m

(* {1 Examples} *)

let far_away () =
  let width = 60 and height = 600 in
  let spot x y = if x = 20 && y = 300 then (255, 255, 255) else ramp x y in
  let m = flip (display ~width ~height ramp) (display ~width ~height spot) in
  let reach = Flip.reach ~ppd:Flip.default_ppd in
  let inside x y = abs (x - 20) <= reach && abs (y - 300) <= reach in
  Alcotest.(check bool)
    "only around the spot" true
    (for_all (fun x y -> inside x y || Flip.at m x y = 0.) m);
  Alcotest.(check bool) "there it is" true (Flip.at m 20 300 > 0.1)

(* Bands of rows are worked on apart; a picture's lower part, cut anywhere, must
   give the same bits as long as its upper edge is out of reach. *)
let bands () =
  let width = 6 and height = 530 and cut = 100 in
  let whole =
    flip (display ~width ~height plaid) (display ~width ~height shifted)
  in
  let below f x y = f x (y + cut) in
  let height = height - cut in
  let lower =
    flip
      (display ~width ~height (below plaid))
      (display ~width ~height (below shifted))
  in
  let reach = Flip.reach ~ppd:Flip.default_ppd in
  Alcotest.(check bool)
    "same bits" true
    (for_all
       (fun x y ->
         y < reach
         || Float.equal (Flip.at lower x y) (Flip.at whole x (y + cut)))
       lower)

let sizes () =
  let wide = display ~width:3 ~height:1 plaid
  and high = display ~width:1 ~height:3 plaid in
  match Flip.v ~ppd:67. wide high with
  | Ok _ -> Alcotest.fail "accepted"
  | Error why ->
      Alcotest.(check string)
        "why" "the pictures differ in size: 3x1 and 1x3" why

let misuse () =
  let one = display ~width:1 ~height:1 plaid in
  let refused ppd =
    match Flip.v ~ppd one one with
    | Ok _ | Error _ -> Alcotest.failf "ppd %g" ppd
    | exception Invalid_argument _ -> ()
  in
  List.iter refused [ nan; infinity; 0.; 0.9; 1001. ];
  Alcotest.(check (float 1e-6))
    "the authors' display" 67.020643 Flip.default_ppd

let heatmaps () =
  let m =
    flip
      (display ~width:20 ~height:7 plaid)
      (display ~width:20 ~height:7 shifted)
  in
  let agrees format colour =
    let p = Flip.heatmap format m in
    for_all
      (fun x y -> Rgb.equal (Picture.pixel p x y) (colour (Flip.at m x y)))
      m
  in
  Alcotest.(check bool) "pfm" true (agrees Pfm Rgb.grey);
  Alcotest.(check bool) "png" true (agrees Png Magma.colour);
  Alcotest.(check bool) "ppm" true (agrees Ppm Magma.colour)

let text () =
  let one f = display ~width:1 ~height:1 f in
  let line ?ppd () =
    Flip.to_text (flip ?ppd (one (flat 0 0 0)) (one (flat 255 255 255)))
  in
  Alcotest.(check string)
    "line" "flip       0.96738 (67 pixels per degree)\n" (line ());
  Alcotest.(check string)
    "tenths" "flip       0.96738 (33.5 pixels per degree)\n" (line ~ppd:33.5 ())

let law = law ~count:100

let tests =
  [
    unit "the map is that of the authors' program" values;
    unit "the greatest differences are the authors'" extremes;
    law "the map is within 0 and 1" (pair_of either) within;
    law "nothing is seen between a picture and itself" (pair_of either) nothing;
    law "which picture is the reference does not matter" (pair_of either)
      symmetric;
    law "brighter than white is white, and nan is black" (pair_of radiance)
      clamps;
    law "8-bit files look like the radiance they display" (pair_of noise)
      decoded;
    unit "nothing is seen beyond the reach of a change" far_away;
    unit "pictures worked on in bands give the same bits" bands;
    unit "pictures that differ in size are an error" sizes;
    unit "pixels per degree out of range are refused" misuse;
    unit "heat maps hold the map, in colours or as it is" heatmaps;
    unit "text has one line" text;
  ]

let suite = ("flip", tests)
