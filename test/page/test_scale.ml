open Candor_cost
open Candor_oracle
open QCheck2

let axis values = Scale.v ~from:500. ~into:20. ~margin:1.3 values

let at name expected place =
  match (place : Scale.place) with
  | At c -> Alcotest.(check (float 0.001)) name expected c
  | Below | Above | Nowhere -> Alcotest.fail (name ^ " has no place")

let places () =
  let s = Scale.v ~from:0. ~into:100. ~margin:2. [ 2.; 50.; 0.; nan ] in
  at "the lowest" 0. (Scale.place s 1.0000000001);
  at "the middle" 50. (Scale.place s 10.);
  at "a tenth of the way" 10. (Scale.place s (100. ** 0.1));
  let is name expected x =
    Alcotest.(check bool) name true (Scale.place s x = expected)
  in
  is "zero" Below 0.;
  is "minus one" Below (-1.);
  is "minus infinity" Below neg_infinity;
  is "infinity" Above infinity;
  is "not a number" Nowhere nan

let round () =
  let is name expected actual =
    Alcotest.(check (list (float 0.0001))) name expected actual
  in
  is "two decades"
    [ 0.5; 1.; 2.; 5.; 10.; 20. ]
    (Scale.decades (axis [ 0.5; 20. ]));
  is "no value"
    [ 0.1; 0.2; 0.5; 1.; 2.; 5.; 10. ]
    (Scale.decades (axis [ nan; 0.; infinity ]));
  is "times"
    [ 10.; 20.; 50.; 60.; 120.; 300. ]
    (Scale.times (axis [ 10.; 300. ]))

let print = Print.(pair (list float) float)

let inside (values, x) =
  match Scale.place (axis values) x with
  | At c -> c >= 20. -. 0.001 && c <= 500.001
  | Below | Above | Nowhere -> true

let finite (values, x) =
  let s = axis values in
  let a, b = Scale.power s (fun l -> Scale.log_coordinate s (l *. x)) in
  List.for_all Float.is_finite [ a; b; Scale.log_coordinate s x ]

let ascending xs = List.sort_uniq Float.compare xs = xs

let readable (values, _) =
  let s = axis values in
  let good ticks = ascending ticks && List.length ticks <= 24 in
  good (Scale.decades s) && good (Scale.times s)

let ordered (values, x) =
  let s = axis values in
  match (Scale.clamped s x, Scale.clamped s (2. *. x)) with
  | Some a, Some b -> if x >= 0. then a >= b else a <= b
  | None, None -> Float.is_nan x
  | Some _, None | None, Some _ -> false

let suite =
  let cases = Gen.pair Hostile.numbers Hostile.number in
  let law name holds = Law.law ~print name cases holds in
  ( "scales",
    [
      Law.example "numbers stand by their logarithms" places;
      Law.example "round numbers on an axis" round;
      law "what has a place is on the axis" inside;
      law "coordinates are finite" finite;
      law "greater numbers stand farther along" ordered;
      law "round numbers ascend and are few" readable;
    ] )
