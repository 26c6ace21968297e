open Candor_oracle
open Candor_scene
open Candor_effect
open Candor_cost

let noisy_pair = Made.noisy_pair (Random.State.make [| 6 |])
let truth = Array.init 60000 (fun i -> 60. +. float_of_int (i mod 97))
let light = Price.Without_light { name = "x"; place = Place.unknown }
let fog = Price.Without_effect { absent = Effect.Fog; reasons = [] }
let base = noisy_pair 2. truth
let darker by = Array.map (fun x -> x -. by) truth
let finest = noisy_pair 0.1 truth

let verdict setting ~saved pair =
  (Verdict.v setting ~law:None ~finest ~base pair ~share:0.25 ~saved).verdict

let show : Price.verdict -> string = function
  | Rung -> "rung"
  | Needed -> "needed"
  | Saves s -> Printf.sprintf "saves %.2f" s
  | Paid_for_nothing -> "paid for nothing"
  | Wrong_pixels n -> Printf.sprintf "%d wrong" n

let check name setting ~saved pair expected =
  Alcotest.(check string) name expected (show (verdict setting ~saved pair))

(* The same noise, as of the same random numbers, on another picture. *)
let same_noise by =
  let shift (m : Measure.t) =
    Made.measure
      (Array.map
         (fun x -> x -. by)
         (Array.of_list (Float.Array.to_list m.shown)))
  in
  { Pair.first = shift base.first; second = shift base.second }

let parts () =
  List.iter
    (fun setting ->
      check "same bits" setting ~saved:0.1 base "paid for nothing";
      check "other noise" setting ~saved:0.1 (noisy_pair 2. truth)
        "paid for nothing";
      check "much darker" setting ~saved:0.9
        (noisy_pair 2. (darker 3.))
        "needed";
      check "hardly darker" setting ~saved:0.2 (same_noise 0.1) "saves 0.20";
      check "hardly darker, no faster" setting ~saved:0. (same_noise 0.1)
        "needed";
      check "noisier" setting ~saved:0.2 (noisy_pair 3. truth) "needed")
    [ light; fog ]

(* Noise so great that nothing can be said is no verdict against a light. *)
let unknown () =
  let truth = Array.sub truth 0 3000 in
  let base = noisy_pair 60. truth in
  let v =
    Verdict.v light ~law:None ~finest:base ~base (noisy_pair 60. truth)
      ~share:1. ~saved:0.1
  in
  Alcotest.(check string) "needed" "needed" (show v.verdict)

let limits () =
  check "the same" (Price.Depth 3) ~saved:0.12 base "saves 0.12";
  check "slower" (Price.Depth 3) ~saved:(-0.1) base "saves 0.00";
  check "darker" (Price.Cutoff 0.1) ~saved:0.5 (same_noise 2.) "needed"

(* Half the noise is worth four times the samples. *)
let samplers () =
  let sobol = Price.Sampler Sobol in
  (match verdict sobol ~saved:0. (noisy_pair 1. truth) with
  | Saves s when Float.abs (s -. 0.75) < 0.05 -> ()
  | v -> Alcotest.failf "half the noise: %s" (show v));
  check "as noisy" sobol ~saved:0. (noisy_pair 2. truth) "needed";
  check "noisier" sobol ~saved:0. (noisy_pair 3. truth) "needed"

let wrong () =
  let off = Array.mapi (fun i x -> if i = 5 then x +. 90. else x) in
  let shown (m : Measure.t) = Array.of_list (Float.Array.to_list m.shown) in
  check "one in four times as many" Price.Naive_math ~saved:0.
    (Made.pair (off (shown base.first)) (off (shown base.second)))
    "4 wrong"

let suite =
  ( "verdict",
    [
      Law.example "lights and effects are needed, or not" parts;
      Law.example "what noise hides is not condemned" unknown;
      Law.example "limits save what does not show" limits;
      Law.example "samplers save what they need less at equal error" samplers;
      Law.example "wrong pixels are counted for the whole picture" wrong;
    ] )
