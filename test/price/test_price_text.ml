open Candor_oracle
open Candor_scene
open Candor_scene_made
open Candor_effect
open Candor_image
open Candor_cost

let place line = { Place.file = "a,b.scene"; line; column = 3 }

let row ?(spp = 16) ?(pareto = false) ?(loss = 0.) ?(verdict = Price.Rung)
    setting (seconds, rays_per_pixel, rms, p99) : Price.row =
  {
    setting;
    spp;
    measure = { seconds; rays_per_pixel; rms; p99 };
    loss;
    pareto;
    verdict;
  }

let one = row ~spp:1 ~pareto:true (Samples 1) (0.41, 2.9, 3.1, 41.)
let sixteen = row ~pareto:true (Samples 16) (4.9, 36., 0.71, 8.)

let others =
  let fog = { Reason.what = "fog"; place = place 8 } in
  [
    row (Depth 3) (4.3, 34., 0.73, 9.) ~loss:0.02 ~verdict:(Saves 0.12);
    row
      (Without_light { name = "point light"; place = place 7 })
      (4., 30., 0.71, 8.) ~verdict:Paid_for_nothing;
    row
      (Without_effect { absent = Fog; reasons = [ fog ] })
      (3., 30., 7., 33.) ~loss:6.9 ~verdict:Needed;
    row (Sampler Independent) (4.9, 36., 0.9, 9.) ~loss:0.19 ~verdict:Needed;
    row Naive_math (4.6, 36., 0.9, 255.) ~loss:0.4 ~verdict:(Wrong_pixels 17);
  ]

let plane = Plane.init ~width:1 ~height:1 (fun _ -> 0.)

let list : Price.t =
  {
    scene = "a,b.scene";
    width = 10;
    height = 10;
    domains = 2;
    pixels = 1;
    budget = 20.;
    spent = 19.;
    ladder = [ one; sixteen ];
    knee = Some sixteen;
    others;
    law = Some { a = 2.; b = 0.5; scatter = 0.1 };
    predictions =
      [ { error = 1.; seconds = 4.; low = 3.; high = 5.; spp = 13 } ];
    views = [];
    time = plane;
    samples = plane;
  }

let scene = Written.scene [ Written.flat_camera ]

let table () =
  Alcotest.(check string)
    "as people read it"
    {| setting                              seconds  rays/px  rms (1/255)  99th pct  s per halving
*spp 1                                  0.410     2.90         3.10      41.0
*spp 16   <- knee                        4.90     36.0        0.710       8.0  2.11
 depth 3 (was 8)                       -0.600    -2.00       +0.020     +1.00  saves 12 %
 without point light [a,b.scene:7:3]   -0.900    -6.00           +0        +0  paid for nothing
 without fog                            -1.90    -6.00        +6.90     +25.0  needed
 independent sampler                       +0       +0       +0.190     +1.00  no better
 naive math                            -0.300       +0       +0.400      +247  17 wrong pixels
paid for nothing: point light [a,b.scene:7:3]
error = 2.00 / seconds^0.50 (within a factor of 1.11)
error 1 takes 4.0 s (95 %: 3.0 s to 5.0 s), 13 spp everywhere
|}
    (Price_text.table scene list)

let csv () =
  Alcotest.(check string)
    "as programs read it"
    {|setting,spp,seconds,rays_per_pixel,rms,p99,pareto
spp 1,1,0.41,2.9,3.1,41,true
spp 16,16,4.9,36,0.71,8,true
depth 3,16,4.3,34,0.73,9,false
"without point light [a,b.scene:7:3]",16,4,30,0.71,8,false
"without fog [a,b.scene:8:3]",16,3,30,7,33,false
independent sampler,16,4.9,36,0.9,9,false
naive math,16,4.6,36,0.9,255,false
|}
    (Price_text.csv list)

let hostile () =
  let odd x = row (Samples 2) (x, x, x, x) in
  let text =
    Price_text.table scene
      {
        list with
        ladder = [ odd nan; odd infinity; odd 0.; odd (-1.); odd 1e300 ];
        knee = None;
        law = Some { a = infinity; b = nan; scatter = infinity };
        predictions =
          [
            {
              error = 1.;
              seconds = infinity;
              low = 0.;
              high = infinity;
              spp = max_int;
            };
          ];
      }
  in
  Alcotest.(check bool) "something is said" true (String.length text > 0)

let suite =
  ( "price text",
    [
      Law.example "the table is what people read" table;
      Law.example "columns for programs" csv;
      Law.example "odd numbers can be printed" hostile;
    ] )
