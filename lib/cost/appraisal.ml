open Candor_scene
open Candor_image

(* {1 Rows} *)

let measure ~seconds pair (error : Pair.error) : Price.measure =
  {
    seconds;
    rays_per_pixel = Pair.rays_per_pixel pair;
    rms = error.rms;
    p99 = error.p99;
  }

let of_rung ({ spp; pair } : Survey.rung) error : Price.row =
  {
    setting = Samples spp;
    spp;
    measure = measure ~seconds:(Pair.seconds pair) pair error;
    loss = 0.;
    pareto = false;
    verdict = Rung;
  }

let of_other survey ~law ~finest (base : Survey.rung) (o : Survey.other) :
    Price.row =
  let setting = Variant.setting o.variant
  and error = Pair.error ~finest o.changed in
  let { Verdict.loss; verdict } =
    Verdict.v setting ~law ~finest ~base:base.pair o.changed
      ~share:(Subset.share survey.Survey.subset)
      ~saved:(1. -. o.ratio)
  in
  {
    setting;
    spp = base.spp;
    measure =
      measure ~seconds:(o.ratio *. Pair.seconds base.pair) o.changed error;
    loss;
    pareto = false;
    verdict;
  }

let point (row : Price.row) =
  { Front.seconds = row.measure.seconds; error = row.measure.rms }

(* Which rows of both lists nothing beats. *)
let with_front ladder others =
  let best = Front.pareto (List.map point (ladder @ others)) in
  let marked =
    List.map2
      (fun (row : Price.row) pareto -> { row with pareto })
      (ladder @ others) best
  in
  let rungs = List.length ladder in
  ( List.filteri (fun i _ -> i < rungs) marked,
    List.filteri (fun i _ -> i >= rungs) marked )

let knee ladder =
  Option.bind (Front.knee (List.map point ladder)) (List.nth_opt ladder)

(* {1 The law} *)

let law_over ladder x =
  let point (row : Price.row) =
    if row.spp > 1 then Some (x row, row.measure.rms) else None
  in
  Power_law.fit (List.filter_map point ladder)

let by_seconds ladder =
  law_over ladder (fun (row : Price.row) -> row.measure.seconds)

let by_samples ladder =
  law_over ladder (fun (row : Price.row) -> float_of_int row.spp)

let whole x =
  if x < float_of_int max_int then int_of_float (Float.ceil x) else max_int

let prediction ~by_seconds ~by_samples error : Price.prediction option =
  match
    (Power_law.inverse by_seconds error, Power_law.inverse by_samples error)
  with
  | Some { best; low; high }, Some samples ->
      let spp = Int.max 1 (whole samples.best) in
      Some { error; seconds = best; low; high; spp }
  | _, None | None, _ -> None

let predictions ladder =
  match (by_seconds ladder, by_samples ladder) with
  | Some by_seconds, Some by_samples ->
      List.filter_map (prediction ~by_seconds ~by_samples) [ 4.; 2.; 1.; 0.5 ]
  | _, None | None, _ -> []

(* {1 Maps} *)

let plane subset f =
  Plane.init ~width:(Subset.width subset) ~height:(Subset.height subset) f

let time subset ({ spp; pair } : Survey.rung) =
  let at (m : Measure.t) i = Float.Array.get m.times i in
  plane subset (fun i ->
      (at pair.first i +. at pair.second i) /. float_of_int (2 * spp))

(* Samples are spent best in proportion to the deviation of one. *)
let samples subset rungs =
  let spread ({ spp; pair } : Survey.rung) =
    if spp = 1 then None else Some (float_of_int spp, Pair.spread pair)
  in
  let spreads = List.filter_map spread rungs in
  let deviation i =
    let add sum (n, spread) = sum +. (n *. Float.Array.get spread i) in
    sqrt (List.fold_left add 0. spreads)
  in
  let deviations = plane subset deviation in
  let mean = Plane.mean deviations in
  plane subset (fun i ->
      if mean > 0. then Plane.get deviations i /. mean else 1.)

(* {1 The list} *)

let errors (survey : Survey.t) =
  let finest = Survey.finest survey in
  let error (rung : Survey.rung) =
    let e = Pair.error ~finest:finest.pair rung.pair in
    if finest.spp > 1 then e else { e with rms = nan; p99 = nan }
  in
  List.map error survey.rungs

let view ({ spp; pair } : Survey.rung) (error : Pair.error) : Price.view =
  { spp; picture = pair.first.picture; error = error.pixels }

let rows survey errors =
  let finest = (Survey.finest survey).pair in
  let ladder = List.map2 of_rung survey.Survey.rungs errors in
  let law = by_seconds ladder in
  let beside base =
    List.map (of_other survey ~law ~finest base) survey.others
  in
  with_front ladder (Option.fold ~none:[] ~some:beside survey.base)

let v (scene : Scene.t) ~file ~domains budget (survey : Survey.t) : Price.t =
  let errors = errors survey in
  let ladder, others = rows survey errors in
  let law { Power_law.a; b; scatter; _ } = { Price.a; b; scatter } in
  {
    scene = file;
    width = scene.width;
    height = scene.height;
    domains;
    pixels = Subset.count survey.subset;
    budget = Budget.whole budget;
    spent = Budget.spent budget;
    ladder;
    knee = knee ladder;
    others;
    law = Option.map law (by_seconds ladder);
    predictions = predictions ladder;
    views = List.map2 view survey.rungs errors;
    time = time survey.subset (Survey.finest survey);
    samples = samples survey.subset survey.rungs;
  }
