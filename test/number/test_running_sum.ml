open Candor_number
open Candor_oracle
open Numbers
open QCheck2

let sum = List.fold_left Running_sum.add Running_sum.zero
let total xs = Running_sum.total (sum xs)
let exact = List.fold_left (fun s x -> Q.add s (Exact.q x)) Q.zero
let sizes = List.fold_left (fun s x -> Q.add s (Exact.q (Float.abs x))) Q.zero
let repeated n x s = Seq.fold_left Running_sum.add s (Seq.take n (Seq.repeat x))
let check name = Alcotest.(check (float 0.)) name

let tenths () =
  let s = repeated 1_000_000 0.1 Running_sum.zero in
  let truth = Q.mul (Q.of_int 1_000_000) (Exact.q 0.1) in
  check "10^6 x 0.1" (Q.to_float truth) (Running_sum.total s)

let large_and_small () =
  check "1 + 1e100 + 1 - 1e100" 2. (total [ 1.; 1e100; 1.; -1e100 ]);
  check "1e100 + 1 - 1e100 + 1" 2. (total [ 1e100; 1.; -1e100; 1. ])

(* Each term is below half a unit in the last place of the sum, and ten million
   of them are many units. *)
let many_small () =
  let s = repeated 10_000_000 1e5 (sum [ 1e22 ]) in
  check "1e22 + 10^7 x 1e5" (1e22 +. 1e12) (Running_sum.total s);
  check "without 1e22" 1e12 Running_sum.(total (add s (-1e22)));
  check "10^7 x 1e5" 1e12
    Running_sum.(total (repeated 10_000_000 1e5 Running_sum.zero))

let odd () =
  check "an infinity" infinity (total [ 1.; infinity; 1.; 2. ]);
  check "overflow" neg_infinity (total [ -.max_float; -.max_float; 5. ]);
  check "two infinities" nan (total [ infinity; neg_infinity; 1. ]);
  check "nan" nan (total [ 1.; nan; 1. ]);
  check "joined" infinity Running_sum.(total (join (sum [ infinity ]) zero));
  check "nothing" 0. (total [])

let terms = Gen.(list_size (int_range 0 60) real)
let show = Print.list (Printf.sprintf "%h")

(* Half an ulp, and 2^-104 of the sizes for each step. *)
let right xs s =
  let truth = exact xs and t = Running_sum.total s in
  let steps = Q.mul (Q.of_int (List.length xs)) (Exact.power (-104)) in
  Q.leq
    (Q.abs Exact.(q t - truth))
    Exact.((q (ulp t) / two) + (steps * sizes xs))

let joined (xs, ys) =
  let both = xs @ ys in
  right both (Running_sum.join (sum xs) (sum ys))

(* Any two orders of terms of one sign round the same number, nearly. *)
let any_order xs =
  let xs = List.map Float.abs xs in
  let s = total xs and s' = total (List.sort Float.compare xs) in
  Float.abs (s -. s') <= Exact.ulp s

(* In the middle of others, which stay as they are. *)
let in_place (xs, at) =
  let a = Float.Array.make 8 0.5 in
  Float.Array.fill a at 2 0.;
  let add s x =
    Running_sum.accumulate a at x;
    let s = Running_sum.add s x in
    (* Both words of it: [compare] takes nan for nan. *)
    if compare s (Running_sum.held a at) = 0 then s
    else Law.fail "%h, in place %h" (Running_sum.total s) (Float.Array.get a at)
  in
  let (_ : Running_sum.t) = List.fold_left add Running_sum.zero xs in
  List.for_all
    (fun i -> i = at || i = at + 1 || Float.Array.get a i = 0.5)
    (List.init 8 Fun.id)

let awkward =
  Gen.(
    oneof
      [ real; real; real; Draw.pick [ infinity; neg_infinity; nan; max_float ] ])

let suite =
  ( "running sums",
    [
      Law.example "G18: a million tenths add up to the last bit" tenths;
      Law.example "G18: what is small survives what is large" large_and_small;
      Law.example "G19: the correction never saturates" many_small;
      Law.law ~count:5000 ~print:show
        "G18: a sum is off by half an ulp and n·2^-104 of its terms" terms
        (fun xs -> right xs (sum xs));
      Law.law
        ~print:(fun (xs, ys) -> show xs ^ " and " ^ show ys)
        "a sum of parts is right likewise" (pair terms) joined;
      Law.law ~print:show "order moves a sum by an ulp at most" terms any_order;
      Law.example "infinities and nan are not lost" odd;
      Law.law
        ~print:(fun (xs, at) -> Printf.sprintf "at %d: %s" at (show xs))
        "in place a sum has the bits that it has elsewhere"
        Gen.(pair (list_size (int_range 0 40) awkward) (int_bound 6))
        in_place;
    ] )
