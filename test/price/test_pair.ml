open Candor_oracle
open Candor_image
open Candor_cost

let noisy_pair = Made.noisy_pair (Random.State.make [| 5 |])
let truth n = Array.init (3 * n) (fun i -> 60. +. float_of_int (i mod 97))

let near name ~by expected found =
  if not (Float.abs (found -. expected) <= by *. expected) then
    Alcotest.failf "%s: %g instead of %g" name found expected

(* The finest has half the noise of the rung: unsubtracted, errors would be 12 %
   too great. *)
let unbiased () =
  let truth = truth 20000 in
  let finest = noisy_pair 1. truth and rung = noisy_pair 2. truth in
  let of_rung = Pair.error ~finest rung
  and of_finest = Pair.error ~finest finest in
  near "rms" ~by:0.02 2. of_rung.rms;
  near "rms of the finest" ~by:0.02 1. of_finest.rms;
  (* χ² of three channels: 11.34 at .99. *)
  near "99 %" ~by:0.04 (2. *. sqrt (11.34 /. 3.)) of_rung.p99;
  near "mean over pixels" ~by:0.05 4.
    (Plane.mean
       (Plane.init ~width:(Plane.width of_rung.pixels) ~height:1 (fun i ->
            Plane.get of_rung.pixels i ** 2.)))

let biased () =
  let truth = truth 20000 in
  let finest = noisy_pair 1. truth in
  let dark = Array.map (fun x -> x -. 3.) truth in
  near "bias counts" ~by:0.02 (sqrt 10.)
    (Pair.error ~finest (noisy_pair 1. dark)).rms

let exact () =
  let truth = truth 30 in
  let pair = Made.pair truth truth in
  let e = Pair.error ~finest:pair pair in
  Alcotest.(check (float 0.)) "rms" 0. e.rms;
  Alcotest.(check (float 0.)) "99 %" 0. e.p99

let change a b = Pair.change ~base:a b

let equal () =
  let base = noisy_pair 2. (truth 500) in
  let c = change base base in
  Alcotest.(check bool) "equal" true c.equal;
  Alcotest.(check bool) "shows" false c.shows;
  Alcotest.(check (float 0.)) "loss" 0. c.loss;
  Alcotest.(check (float 0.)) "bound" 0. c.bound

let unlike () =
  let truth = truth 3000 in
  let base = noisy_pair 2. truth in
  let found = ref 0 in
  for _ = 1 to 100 do
    let c = change base (noisy_pair 2. truth) in
    Alcotest.(check bool) "not equal" false c.equal;
    if c.shows then incr found
  done;
  if !found > 5 then Alcotest.failf "%d false alarms of 100" !found

let seen () =
  let truth = truth 3000 in
  let base = noisy_pair 2. truth in
  let shows name pair =
    let c = change base pair in
    Alcotest.(check bool) name true c.shows;
    c
  in
  let moved by = Array.map (fun x -> x +. by) truth in
  let lost = shows "darker" (noisy_pair 2. (moved (-5.))) in
  near "loss" ~by:0.05 5. lost.loss;
  if lost.bound < 5. then Alcotest.failf "the bound is %g" lost.bound;
  let slight = shows "a little darker" (noisy_pair 2. (moved (-0.3))) in
  Alcotest.(check bool) "noise alone is no loss" true (slight.loss < 0.7);
  let few = Array.mapi (fun i x -> if i < 30 then x +. 80. else x) truth in
  near "a few pixels" ~by:0.05
    (80. /. sqrt 300.)
    (shows "a few pixels" (noisy_pair 2. few)).loss;
  let noisier = shows "noisier" (noisy_pair 3. truth) in
  Alcotest.(check bool) "noisier" true (noisier.noisier && noisier.loss < 0.5);
  let quieter = change base (noisy_pair 1. truth) in
  Alcotest.(check bool) "quieter" true (quieter.quieter && not quieter.noisier)

let wrong () =
  let truth = truth 100 in
  let off places by =
    Array.mapi (fun i x -> if List.mem i places then x +. by else x) truth
  in
  let base = Made.pair truth truth in
  let count name expected pair =
    Alcotest.(check int) name expected (Pair.wrong ~base pair)
  in
  count "none" 0 base;
  count "three pixels" 3
    (Made.pair (off [ 0; 1; 30; 62 ] 9.) (off [ 0; 30; 62 ] 9.));
  count "less than a level" 0 (Made.pair (off [ 5 ] 0.9) (off [ 5 ] 0.9));
  count "by chance" 0 (Made.pair (off [ 5 ] 9.) truth);
  count "both ways" 0 (Made.pair (off [ 5 ] 9.) (off [ 5 ] (-9.)))

let suite =
  ( "pair",
    [
      Law.example "errors are those beside the truth, not beside the finest"
        unbiased;
      Law.example "what is missing counts" biased;
      Law.example "what is exact has no error" exact;
      Law.example "equal pictures have not changed" equal;
      Law.example "other noise of the same kind is no change" unlike;
      Law.example "changes are seen through noise" seen;
      Law.example "wrong pixels are wrong in both sets" wrong;
    ] )
