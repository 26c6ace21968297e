open Candor_cost
open Candor_oracle

let rung spp seconds rms : Price.row =
  {
    setting = Samples spp;
    spp;
    measure = { seconds; rays_per_pixel = 1.; rms; p99 = rms };
    loss = 0.;
    pareto = true;
    verdict = Rung;
  }

let price ladder = { (Lazy.force Showcase.price) with ladder; knee = None }

let halving () =
  let is name expected ladder =
    let prices = List.map snd (Ladder.per_halving (price ladder)) in
    Alcotest.(check (list (option (float 0.0001)))) name expected prices
  in
  is "empty" [] [];
  is "a quarter in 6 s more" [ None; Some 3. ] [ rung 1 2. 8.; rung 2 8. 2. ];
  is "no gain" [ None; None; None ] [ rung 1 2. 8.; rung 2 4. 8.; rung 4 8. 9. ];
  is "faster and worse" [ None; None ] [ rung 1 4. 2.; rung 2 2. 4. ];
  is "no error left" [ None; None ] [ rung 1 2. 8.; rung 2 4. 0. ];
  is "no number" [ None; None ] [ rung 1 2. nan; rung 2 4. 1. ]

let saving () =
  let p = price [ rung 1 2. 8.; rung 2 4. 4. ] in
  let is name expected r =
    Alcotest.(check (option (float 0.0001))) name expected (Ladder.saving p r)
  in
  is "a quarter" (Some 0.25) { (rung 2 3. 5.) with setting = Naive_math };
  is "dearer" (Some (-0.5)) { (rung 1 3. 5.) with setting = Naive_math };
  is "no base" None { (rung 4 3. 5.) with setting = Naive_math }

let suite =
  ( "ladders",
    [
      Law.example "seconds per halving of the error" halving;
      Law.example "savings beside the same samples" saving;
    ] )
