open Candor_scene
open Candor_cost
open Candor_oracle

let check name expected actual = Alcotest.(check string) name expected actual
let place line : Place.t = { file = "a.scene"; line; column = 3 }
let lamp place = Price.Without_light { name = "spot light"; place }

let names () =
  let is expected s = check expected expected (Wording.setting s) in
  is "1 sample" (Samples 1);
  is "16 samples" (Samples 16);
  is "depth 3" (Depth 3);
  is "sobol sampler" (Sampler Sobol);
  is "without spot light, line 12" (lamp (place 12));
  is "without spot light" (lamp Place.unknown);
  is "without fog" (Without_effect { absent = Fog; reasons = [] })

let keys () =
  let is expected i = check expected expected (Wording.key i) in
  is "a" 0;
  is "z" 25;
  is "a1" 26;
  is "b2" 53

let verdicts () =
  let is name expected setting verdict =
    let r = List.hd (Lazy.force Showcase.price).others in
    Alcotest.(check (option string))
      name expected
      (Wording.verdict { r with setting; verdict })
  in
  is "a rung" None (Samples 4) Rung;
  is "a sampler" (Some "no better") (Sampler Stratified) Needed;
  is "a light" (Some "needed") (lamp Place.unknown) Needed;
  is "a pixel" (Some "1 wrong pixel") Naive_math (Wrong_pixels 1);
  is "none" (Some "no wrong pixel") Naive_math (Wrong_pixels 0)

let places () =
  let count n s =
    Alcotest.(check int) (Wording.setting s) n (List.length (Wording.places s))
  in
  count 1 (lamp (place 12));
  count 0 (lamp Place.unknown);
  count 0 Naive_math

let suite =
  ( "wording",
    [
      Law.example "settings have names, lights their lines" names;
      Law.example "keys are letters, then letters with numbers" keys;
      Law.example "verdicts" verdicts;
      Law.example "places that no file says are left out" places;
    ] )
