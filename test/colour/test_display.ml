open Candor_colour
open Candor_oracle
open QCheck2

(* smallpt.cpp, lines 11 and 12, word by word. *)
let clamp x = if x < 0. then 0. else if x > 1. then 1. else x
let to_int x = int_of_float ((Float.pow (clamp x) (1. /. 2.2) *. 255.) +. 0.5)

(* The first double that displays as [n] or more. *)
let threshold n =
  let rec search low high =
    let middle = low +. ((high -. low) /. 2.) in
    if middle <= low || middle >= high then high
    else if Display.level middle >= n then search low middle
    else search middle high
  in
  search 0. 1.

let levels = List.init 256 Fun.id
let check_int = Alcotest.(check int)

let thresholds () =
  List.iter
    (fun n ->
      let x = threshold n in
      let expected = ((float_of_int n -. 0.5) /. 255.) ** 2.2 in
      check_int (Printf.sprintf "at the threshold of %d" n) n (Display.level x);
      check_int "just below it" (n - 1) (Display.level (Float.pred x));
      if Float.abs (x -. expected) > 1e-13 *. expected then
        Alcotest.failf "the threshold of %d is %h, not %h" n x expected)
    (List.tl levels)

let around () =
  let near x = [ Float.pred x; x; Float.succ x ] in
  let decoded = List.concat_map (fun n -> near (Display.decode n)) levels in
  let thresholds =
    List.concat_map (fun n -> near (threshold n)) (List.tl levels)
  in
  List.iter
    (fun x -> check_int (Printf.sprintf "%h" x) (to_int x) (Display.level x))
    (decoded @ thresholds)

let by_hand () =
  List.iter
    (fun (x, n) -> check_int (string_of_float x) n (Display.level x))
    [
      (0., 0);
      (0.001, 11);
      (0.01, 31);
      (0.18, 117);
      (0.25, 136);
      (0.5, 186);
      (0.75, 224);
      (1., 255);
    ]

let round_trip () =
  List.iter
    (fun n -> check_int "level (decode n)" n (Display.level (Display.decode n)))
    levels;
  Alcotest.(check (float 0.)) "0 is dark" 0. (Display.decode 0);
  Alcotest.(check (float 0.)) "255 is 1" 1. (Display.decode 255)

let odd () =
  let encodes name x y =
    Alcotest.(check (float 0.)) name y (Display.encode x)
  in
  encodes "nan" nan 0.;
  encodes "-nan" (-.nan) 0.;
  encodes "infinity" infinity 255.;
  encodes "minus infinity" neg_infinity 0.;
  encodes "minus zero" (-0.) 0.;
  encodes "below 0" (-0.5) 0.;
  encodes "just below 0" (-1e-17) 0.;
  encodes "above 1" 1.5 255.;
  encodes "far above 1" 1e300 255.;
  encodes "one" 1. 255.;
  List.iter
    (fun (x, n) -> check_int (Printf.sprintf "level %h" x) n (Display.level x))
    [ (5e-324, 0); (-1e-17, 0); (nan, 0); (1e300, 255); (infinity, 255) ]

let any =
  Gen.oneof [ Draw.uniform (-0.2) 1.2; Draw.coordinate; Draw.wide (-12.) 0. ]

let law name f = Law.law ~print:(Printf.sprintf "%h") name any f

let suite =
  ( "display encoding",
    [
      Law.example "values worked out by hand" by_hand;
      Law.example "level n begins at ((n - 1/2)/255)^2.2, for every n"
        thresholds;
      Law.example "smallpt's formula at every level and threshold, to the ulp"
        around;
      law "smallpt's formula anywhere" (fun x -> Display.level x = to_int x);
      Law.example "every level survives decode and level" round_trip;
      Law.example "G17: nan, infinities and what is outside [0;1]" odd;
      law "encode stays in [0;255] and level is its nearest whole number"
        (fun x ->
          let e = Display.encode x and n = float_of_int (Display.level x) in
          0. <= e && e <= 255. && n <= e +. 0.5 && e +. 0.5 < n +. 1.);
      Law.law
        ~print:(fun (x, y) -> Printf.sprintf "%h %h" x y)
        "brighter light never encodes darker" (Gen.pair any any)
        (fun (x, y) -> x > y || Display.encode x <= Display.encode y);
    ] )
