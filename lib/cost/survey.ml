open Candor_scene

type request = {
  scene : Scene.t;
  domains : int;
  budget : Budget.t;
  stop : unit -> bool;
  progress : float -> unit;
}

type rung = { spp : int; pair : Pair.t }
type other = { variant : Variant.t; changed : Pair.t; ratio : float }

type t = {
  subset : Subset.t;
  rungs : rung list;
  base : rung option;
  others : other list;
  missing : Variant.t list;
}

let finest s =
  List.fold_left
    (fun best rung -> if rung.spp > best.spp then rung else best)
    (List.hd s.rungs) s.rungs

(* {1 Measuring} *)

(* [late] measurements are not stopped by the budget. *)
let measure r ~late subset pixel =
  let stop () = r.stop () || ((not late) && Budget.left r.budget = 0.) in
  let measured = Measure.run ~domains:r.domains ~stop subset pixel in
  let share = Budget.spent r.budget /. Budget.whole r.budget in
  r.progress (Float.min 1. share);
  measured

let set r ~late subset variant spp seeding =
  measure r ~late subset (Variant.compile variant ~spp seeding)

let ( let* ) = Option.bind

let pair r ~late subset variant spp =
  let* first = set r ~late subset variant spp First in
  let* second = set r ~late subset variant spp Second in
  Some { Pair.first; second }

(* [own] is what [variant] changes, in between. *)
let beside r subset ~own variant spp =
  let set = set r ~late:false subset in
  let* first = set variant spp First in
  let* own = measure r ~late:false subset own in
  let* second = set variant spp Second in
  let changed = { Pair.first; second } in
  Some { variant; changed; ratio = Pair.seconds changed /. own.seconds }

let timed r f =
  let before = Budget.spent r.budget in
  let x = f () in
  (x, Budget.spent r.budget -. before)

(* {1 How much to measure} *)

(* What things take, in seconds: to make a scene ready, and to render a sample
   of a pixel with all domains busy. *)
type pace = { ready : float; sample : float }

(* How long so many sets of samples take. *)
let expected pace subset ~sets spp =
  let samples = float_of_int (sets * spp * Subset.count subset) in
  (float_of_int sets *. pace.ready) +. (samples *. pace.sample)

let paced pace subset spp seconds =
  let samples = float_of_int (2 * spp * Subset.count subset) in
  let rendering = Float.max 0. (seconds -. (2. *. pace.ready)) in
  { pace with sample = rendering /. samples }

let subset r pixels =
  let { Scene.width; height; settings; _ } = r.scene in
  Subset.make ~width ~height ~seed:settings.seed ~pixels

type trial = { few : Subset.t; measured : Measure.t; pace : pace }

(* A few pixels more each time, until they take long enough to be timed. *)
let try_out r =
  let pixel, ready =
    timed r (fun () -> Variant.(compile (own r.scene 1) ~spp:1 First))
  in
  let enough = Budget.whole r.budget /. 100. in
  let rec go pixels last =
    let few = subset r pixels in
    match measure r ~late:(pixels = 1) few pixel with
    | None -> last
    | Some measured ->
        let busy = Float.Array.fold_left ( +. ) 0. measured.times in
        let seconds = busy /. float_of_int r.domains in
        let sample = seconds /. float_of_int (Subset.count few) in
        let trial = Some { few; measured; pace = { ready; sample } } in
        if seconds < enough && pixels < 4096 && Subset.share few < 1. then
          go (4 * pixels) trial
        else trial
  in
  go 1 None

(* About as many pixels as tell an error to a few per cent; fewer if that leaves
   too few samples to each. A ladder takes four times the samples of its finest
   rung. *)
let pixels r pace ~others =
  let most = 16384 and few = 400 in
  let scenes = float_of_int ((3 * others) + 16) in
  let left = Budget.left r.budget in
  let seconds = Float.max (left /. 2.) (left -. (scenes *. pace.ready)) in
  let afford spp =
    let own = Int.min spp r.scene.settings.spp in
    let samples = float_of_int ((4 * spp) + (3 * others * own)) in
    let n = seconds /. (pace.sample *. samples) in
    if n >= float_of_int most then most
    else if n > 1. then int_of_float n
    else 1
  in
  Int.max (afford 64) (Int.min few (afford 8))

(* {1 The ladder} *)

let most_samples = 4096

let ladder own =
  let rec doubled n = if n > most_samples then [] else n :: doubled (2 * n) in
  let own = if own > most_samples then [] else [ own ] in
  List.sort_uniq Int.compare (own @ doubled 1)

(* What to keep for other settings beside a rung: not more than half of all. *)
let reserve r pace subset ~others spp =
  let own = Int.min spp r.scene.settings.spp in
  Float.min
    (Budget.whole r.budget /. 2.)
    (float_of_int others *. expected pace subset ~sets:3 own)

(* The rungs measured, finest first, and the pace of the last. The first is
   measured in any case. *)
let rec climb r subset ~others pace rungs = function
  | [] -> (rungs, pace)
  | spp :: higher -> (
      let late = rungs = [] in
      let needed =
        expected pace subset ~sets:2 spp +. reserve r pace subset ~others spp
      in
      if not (late || needed <= Budget.left r.budget) then (rungs, pace)
      else
        let own = Variant.own r.scene spp in
        match timed r (fun () -> pair r ~late subset own spp) with
        | None, _ -> (rungs, pace)
        | Some pair, seconds ->
            let pace = paced pace subset spp seconds in
            climb r subset ~others pace ({ spp; pair } :: rungs) higher)

(* {1 The others} *)

(* Of the rungs up to the scene's own samples the finest that leaves time for
   all other settings; else the coarsest that says something. *)
let base r pace subset rungs ~others =
  let affordable rung =
    float_of_int others *. expected pace subset ~sets:3 rung.spp
    <= Budget.left r.budget
  in
  let useful =
    List.filter (fun rung -> rung.spp <= r.scene.settings.spp) rungs
  in
  match List.find_opt affordable useful with
  | Some _ as rung -> rung
  | None -> (
      match List.filter (fun rung -> rung.spp >= 4) useful with
      | [] -> List.nth_opt useful 0
      | some -> List.nth_opt (List.rev some) 0)

let other r pace subset ~own (base : rung) variant =
  let in_time = expected pace subset ~sets:3 base.spp <= Budget.left r.budget in
  match if in_time then beside r subset ~own variant base.spp else None with
  | Some other -> Either.Left other
  | None -> Right variant

(* {1 All of it} *)

(* When making the scene ready has taken all the time. *)
let nothing_more { few; measured; _ } variants =
  let pair = { Pair.first = measured; second = measured } in
  {
    subset = few;
    rungs = [ { spp = 1; pair } ];
    base = None;
    others = [];
    missing = variants;
  }

let of_trial r trial variants =
  let others = List.length variants in
  let subset = subset r (pixels r trial.pace ~others) in
  let rungs, pace =
    climb r subset ~others trial.pace [] (ladder r.scene.settings.spp)
  in
  let base = base r pace subset rungs ~others in
  let others, missing =
    match base with
    | None -> ([], variants)
    | Some base ->
        let own =
          Variant.(compile (own r.scene base.spp) ~spp:base.spp First)
        in
        List.partition_map (other r pace subset ~own base) variants
  in
  { subset; rungs = List.rev rungs; base; others; missing }

let run r =
  let variants = Variant.others r.scene in
  match try_out r with
  | None -> None
  | Some trial ->
      let survey =
        if Budget.left r.budget = 0. then nothing_more trial variants
        else of_trial r trial variants
      in
      if r.stop () || survey.rungs = [] then None else Some survey
