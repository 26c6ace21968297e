(* Numbers and price lists as bad as their types allow. *)

open QCheck2
open Candor_scene
open Candor_effect
open Candor_image
open Candor_cost

let any xs = Gen.oneof (List.map Gen.pure xs)

let number =
  Gen.oneof
    [
      any
        [
          0.;
          -0.;
          1.;
          -1.;
          nan;
          infinity;
          neg_infinity;
          5e-324;
          max_float;
          -.max_float;
        ];
      Gen.float;
      Gen.map (fun e -> 10. ** e) (Gen.float_range (-6.) 6.);
    ]

let numbers = Gen.(list_size (int_bound 12) number)

let name =
  any
    [
      "";
      "<script>&amp;\"'";
      "a\"b.scene";
      "</style></title>";
      "\255\000";
      "x y";
    ]

let count = any [ min_int; -1; 0; 1; 2; 64; 65536; max_int ]

let place =
  Gen.map2 (fun file line : Place.t -> { file; line; column = line }) name count

let setting : Price.setting Gen.t =
  let open Gen in
  oneof
    [
      map (fun n -> Price.Samples n) count;
      map (fun n -> Price.Depth n) count;
      map (fun w -> Price.Cutoff w) number;
      any
        [
          Price.Sampler Independent;
          Sampler Stratified;
          Sampler Sobol;
          Naive_math;
        ];
      map2 (fun name place -> Price.Without_light { name; place }) name place;
      map3
        (fun absent what place ->
          Price.Without_effect { absent; reasons = [ Reason.v what place ] })
        (any Effect.all) name place;
      map
        (fun absent -> Price.Without_effect { absent; reasons = [] })
        (any Effect.all);
    ]

let verdict : Price.verdict Gen.t =
  let open Gen in
  oneof
    [
      any [ Price.Rung; Needed; Paid_for_nothing ];
      map (fun s -> Price.Saves s) number;
      map (fun n -> Price.Wrong_pixels n) count;
    ]

let measure : Price.measure Gen.t =
  let open Gen in
  let+ seconds = number
  and+ rays_per_pixel = number
  and+ rms = number
  and+ p99 = number in
  { Price.seconds; rays_per_pixel; rms; p99 }

let row : Price.row Gen.t =
  let open Gen in
  let+ setting = setting
  and+ spp = count
  and+ measure = measure
  and+ loss = number
  and+ pareto = bool
  and+ verdict = verdict in
  { Price.setting; spp; measure; loss; pareto; verdict }

let rows = Gen.(list_size (int_bound 5) row)

let plane =
  let open Gen in
  let* width = int_range 1 3 and* height = int_range 1 3 in
  let+ all = array_size (pure (width * height)) number in
  Plane.init ~width ~height (Array.get all)

let view : Price.view Gen.t =
  let open Gen in
  let+ spp = count and+ error = plane in
  let picture =
    Picture.init ~width:(Plane.width error) ~height:(Plane.height error)
      (fun x y ->
        let v = Plane.get error ((y * Plane.width error) + x) in
        Candor_colour.Rgb.v v (-.v) 1.)
  in
  { Price.spp; picture; error }

let prediction : Price.prediction Gen.t =
  let open Gen in
  let+ error = oneof [ number; any [ 4.; 2.; 1.; 0.5 ] ]
  and+ seconds = number
  and+ low = number
  and+ high = number
  and+ spp = count in
  { Price.error; seconds; low; high; spp }

let law : Price.law Gen.t =
  Gen.map3 (fun a b scatter -> { Price.a; b; scatter }) number number number

let price : Price.t Gen.t =
  let open Gen in
  let* ladder = rows and* own = option row in
  let* knee = any (own :: List.map Option.some ladder) in
  let+ scene = name
  and+ width = count
  and+ pixels = count
  and+ budget = number
  and+ spent = number
  and+ others = rows
  and+ law = option law
  and+ predictions = list_size (int_bound 4) prediction
  and+ views = list_size (int_bound 2) view
  and+ time = plane
  and+ samples = plane in
  {
    Price.scene;
    width;
    height = width;
    domains = 1;
    pixels;
    budget;
    spent;
    ladder;
    knee;
    others;
    law;
    predictions;
    views;
    time;
    samples;
  }
