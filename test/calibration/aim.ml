(* Renders to an error: whether they keep it, what they spend beside one that
   knows its true error, and how well they foretell what they spend. *)

open Candor_number
open Candor_scene
open Candor_render

type run = {
  kept : bool;  (** whether the true error is at most the target *)
  samples : float;  (** it took *)
  spent : float;  (** the same, as a share of those that were needed *)
  forecasts : Forecast.t list;
}

type t = {
  name : string;
  error : float;  (** the target *)
  confidence : float;
  pixels : int;
  runs : run list;
}

(* Where the line through the points (n, e) before and after first comes down to
   the target, on logarithmic scales. *)
let crossing ~target (n, e) (n', e') =
  let share = Float.log (e /. target) /. Float.log (e /. e') in
  n *. ((n' /. n) ** share)

(* How many samples a render that knows its true error spends, from the samples
   and true errors after each pass. Past the last, errors fall as 1/√n. *)
let rec needed ~target = function
  | (n, e) :: _ when e <= target -> n
  | [ (n, e) ] -> n *. ((e /. target) ** 2.)
  | before :: ((_, e) as after) :: _ when e <= target ->
      crossing ~target before after
  | _ :: rest -> needed ~target rest
  | [] -> nan

(* None of these seeds is judged with a fixed number of samples. *)
let first_seed = 1000

let target ~error ~confidence =
  { Adaptive.error = Some error; confidence; left = None; most = 1 lsl 20 }

let run truth (scene : Scene.t) ~error ~confidence seed =
  let shot = Shot.make scene seed in
  let steps = ref [] in
  let taken () = float_of_int (Shot.samples shot) in
  let pass () =
    steps := (taken (), Truth.error truth (Shot.results shot)) :: !steps
  in
  Shot.adaptive shot (target ~error ~confidence) ~pass
  |> Option.map (fun (o : Adaptive.outcome) ->
      let samples = taken () in
      {
        kept = Truth.error truth o.results <= error;
        samples;
        spent = samples /. needed ~target:error (List.rev !steps);
        forecasts = o.forecasts;
      })

(** [v truth case ~error ~confidence] is half as many runs as there are seeds.
*)
let v truth (case : Case.t) ~error ~confidence =
  let run seed = run truth case.scene ~error ~confidence (first_seed + seed) in
  let { Scene.width; height; _ } = case.scene in
  {
    name = case.name;
    error;
    confidence;
    pixels = width * height;
    runs =
      Parallel.map run (List.init ((Case.runs + 1) / 2) Fun.id)
      |> List.filter_map Fun.id;
  }

(* {1 What they amount to} *)

let share f list =
  float_of_int (List.length (List.filter f list))
  /. float_of_int (List.length list)

(** [kept a] is the share of runs whose true error is at most the target. *)
let kept a = share (fun r -> r.kept) a.runs

(** [fails a ~level] is whether the target is kept so rarely that a promise that
    is kept does it with a probability below [level]. *)
let fails a ~level =
  let n = List.length a.runs in
  let kept = List.length (List.filter (fun r -> r.kept) a.runs) in
  float_of_int kept < a.confidence *. float_of_int n
  && 0.5 *. Binomial.test ~successes:kept n a.confidence < level

(** [samples a] is how many they take for each pixel, on average. *)
let samples a =
  List.fold_left (fun sum r -> sum +. r.samples) 0. a.runs
  /. float_of_int (a.pixels * List.length a.runs)

(** [quantile p xs] is the least of [xs] that a share [p] of them is not above.
*)
let quantile p xs =
  let sorted = List.sort Float.compare xs in
  let n = List.length sorted in
  let rank = int_of_float (Float.ceil (p *. float_of_int n)) in
  List.nth sorted (Int.max 0 (Int.min (n - 1) (rank - 1)))

let spent runs p = quantile p (List.map (fun r -> r.spent) runs)

(* {1 Forecasts} *)

(** [forecasts runs] is each with what it was about. *)
let forecasts runs =
  List.concat_map (fun r -> List.map (fun f -> (f, r.samples)) r.forecasts) runs

let held ((f : Forecast.t), samples) = f.low <= samples && samples <= f.high

(* As a factor, at least 1. *)
let off ((f : Forecast.t), samples) =
  Float.exp (Float.abs (Float.log (f.total /. samples)))
