open Candor_colour
open Candor_sample
open Candor_effect
open Candor_oracle

let survival ?(weight = Rgb.white) ?(beside = Rgb.black) limit tally path =
  Limit.survival limit tally path Key.Bounce ~weight ~beside

let at depth throughput i =
  { (Followed.path i) with Path.depth; throughput = Rgb.grey throughput }

let value = Alcotest.(check (float 0.))

let fixed () =
  let tally = Tally.make () in
  let limit = Limit.Fixed { depth = 3; cutoff = 0.25 } in
  let check name expected path weight =
    value name expected (survival ~weight:(Rgb.grey weight) limit tally path)
  in
  check "below both" 1. (at 2 1. 0) 0.25;
  check "at the depth" 0. (at 3 1. 0) 1.;
  check "below the weight" 0. (at 2 0.5 0) 0.25;
  check "deep and light: counted once" 0. (at 4 0.5 0) 0.25;
  Alcotest.(check (pair int int))
    "counted" (2, 1)
    (Tally.get tally Cut_by_depth, Tally.get tally Cut_by_weight);
  Alcotest.check Lit.rgb "weighed"
    (Rgb.grey (1. +. 0.125 +. 0.125))
    (Tally.left_out tally)

let black () =
  let tally = Tally.make () in
  List.iter
    (fun limit ->
      value "ends" 0. (survival ~weight:Rgb.black limit tally (at 0 1. 0)))
    [
      Limit.Fixed { depth = 0; cutoff = 1. };
      Roulette { depth = 0 };
      Roulette { depth = 9 };
      At_once;
    ];
  Alcotest.(check (pair int int))
    "not counted" (0, 0)
    (Tally.get tally Cut_by_depth, Tally.get tally Cut_by_weight)

let at_once () = value "ends" 0. (survival At_once (Tally.make ()) (at 0 1. 0))

let roulette_depth () =
  let tally = Tally.make () in
  let limit = Limit.Roulette { depth = 2 } in
  value "before" 1. (survival limit tally (at 1 1. 0));
  value "at it" 0. (survival limit tally (at 2 0.5 0));
  Alcotest.check Lit.rgb "weighed" (Rgb.grey 0.5) (Tally.left_out tally);
  Alcotest.(check int) "counted" 1 (Tally.get tally Cut_by_depth)

(* Whatever the depth and what competes, survival is 1 in the mean; it ends
   some paths where it may. *)
let unbiased () =
  let limit = Limit.Roulette { depth = max_int } in
  let n = 20_000 in
  List.iter
    (fun (depth, throughput, weight, beside) ->
      let survivals =
        List.init n (fun i ->
            survival
              ~weight:(Rgb.v weight (weight /. 2.) 0.)
              ~beside:(Rgb.grey beside) limit (Tally.make ())
              (at depth throughput i))
      in
      let mean = List.fold_left ( +. ) 0. survivals /. float_of_int n in
      let most = List.fold_left Float.max 0. survivals in
      (* The variance of 1/p with chance p is 1/p - 1. *)
      let error = sqrt ((most -. 1.) /. float_of_int n) in
      if Float.abs (mean -. 1.) > 5. *. error then
        Alcotest.failf "depth %d, %g, %g beside %g: %g ± %g" depth throughput
          weight beside mean error)
    [
      (0, 1., 0.5, 0.);
      (0, 1., 0.5, 0.5);
      (0, 1., 0.2, 0.6);
      (3, 0.1, 0.2, 0.6);
      (5, 1., 1., 0.);
      (5, 1., 0.5, 0.);
      (9, 2., 0.9, 0.);
      (9, 0.3, 0.9, 0.3);
      (60, 0.05, 0.5, 0.);
    ]

let certain () =
  let limit = Limit.Roulette { depth = max_int } in
  for i = 0 to 99 do
    value "the first steps go on where nothing competes" 1.
      (survival ~weight:(Rgb.grey 0.01) limit (Tally.make ()) (at 4 0.01 i))
  done;
  let ends =
    List.init 999 (fun i -> survival limit (Tally.make ()) (at 50 1e3 i))
    |> List.filter (fun s -> s = 0.)
  in
  if ends = [] then Alcotest.fail "a path that loses nothing never ends"

let suite =
  ( "limits",
    [
      Law.example "fixed: paths end by depth or weight, and are counted" fixed;
      Law.example "what carries nothing ends, and is not counted" black;
      Law.example "at once: nothing goes on" at_once;
      Law.example "roulette ends at a depth, too" roulette_depth;
      Law.example "roulette: survival is 1 in the mean" unbiased;
      Law.example "roulette begins late, and never stops to end paths" certain;
    ] )
