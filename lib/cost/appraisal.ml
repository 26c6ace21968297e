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

(* Low-discrepancy points are at their best in powers of two: in between errors
   are greater, by no law. One sample at the centre has an error of another
   kind. *)
let is_regular (row : Price.row) = row.spp > 1 && row.spp land (row.spp - 1) = 0

let over ladder x y =
  Power_law.fit
    (List.map
       (fun (row : Price.row) -> (x row, y row))
       (List.filter is_regular ladder))

let seconds (row : Price.row) = row.measure.seconds
let samples (row : Price.row) = float_of_int row.spp
let rms (row : Price.row) = row.measure.rms
let by_seconds ladder = over ladder seconds rms

(* The least power of two that is not below [x]. *)
let rec power_of_two ?(n = 1) x =
  if float_of_int n >= x || n > max_int / 4 then n
  else power_of_two ~n:(2 * n) x

type laws = {
  error_by_seconds : Power_law.t;
  error_by_samples : Power_law.t;
  seconds_by_samples : Power_law.t;
}

let ( let* ) = Option.bind

let laws ladder =
  let* error_by_seconds = by_seconds ladder in
  let* error_by_samples = over ladder samples rms in
  let* seconds_by_samples = over ladder samples seconds in
  Some { error_by_seconds; error_by_samples; seconds_by_samples }

let prediction laws error =
  let* time = Power_law.inverse laws.error_by_seconds error in
  let* samples = Power_law.inverse laws.error_by_samples error in
  let spp = power_of_two (Float.max 2. samples.best) in
  let seconds = Power_law.at laws.seconds_by_samples (float_of_int spp) in
  let times = seconds /. time.best in
  let low = time.low *. times and high = time.high *. times in
  Some { Price.error; seconds; low; high; spp }

let predictions ladder =
  match laws ladder with
  | None -> []
  | Some laws -> List.filter_map (prediction laws) [ 4.; 2.; 1.; 0.5 ]

let error_at (p : Price.t) spp =
  let* laws = laws p.ladder in
  Some (Power_law.at laws.error_by_samples (float_of_int spp))

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
