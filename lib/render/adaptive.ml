open Candor_sample

type target = {
  error : float option;
  confidence : float;
  left : (unit -> float) option;
  most : int;
}

type ending = Met | Misjudged | Out_of_time | Out_of_samples

type outcome = {
  results : Row.result array;
  ending : ending;
  forecasts : Forecast.t list;
}

type job = {
  window : Window.t;
  rows : Row.t array;
  target : target;
  pass : (int -> int -> int) -> unit option;
  expect : Forecast.t -> unit;
  allowed : float; (* seconds that there were in the beginning *)
}

type spent = {
  taken : float; (* samples *)
  effort : float; (* rays and tests *)
  rate : float; (* seconds for each of the last of these *)
}

type state = {
  mean : float; (* samples a pixel, of the rung *)
  base : int; (* that all pixels have *)
  allocation : Allocation.t; (* of the others *)
  squares : float; (* what the base shows of the squared error, of all pixels *)
  before : float; (* what half the base showed *)
  full : bool array; (* parts of which all that may have more have the most *)
  jury : Jury.t;
  spent : spent;
  forecasts : Forecast.t list; (* last first *)
}

let streams = Sampler.streams

let pixels job =
  float_of_int (Window.width job.window * Window.height job.window)

let time_left { left; _ } =
  match left with Some left -> left () | None -> infinity

let left job = time_left job.target
let ( let* ) = Option.bind

(* {1 Passes} *)

let sum_over rows f =
  float_of_int (Array.fold_left (fun n row -> n + f row) 0 rows)

let pass job spent wanted =
  let before = left job in
  let* () = job.pass wanted in
  let taken = sum_over job.rows Row.total in
  let effort = sum_over job.rows Row.effort in
  let more = effort -. spent.effort in
  let rate =
    if before < infinity && more > 0. then (before -. left job) /. more
    else spent.rate
  in
  Some { taken; effort; rate }

let judge job s =
  let { error; confidence; _ } = job.target in
  let jury = Jury.judge ~error ~confidence ~full:s.full job.rows s.jury in
  { s with jury }

(* {1 The end} *)

(* What the ledger says of it is not to be at odds with its numbers; unless who
   asked for less than an even chance got what was asked for. *)
let is_contradicted job results =
  let all = Sampling.sum Row.sampling results in
  let confidence = Float.min 0.5 job.target.confidence in
  match (job.target.error, Sampling.upper ~confidence all) with
  | Some error, Some upper -> upper > error
  | Some _, None -> true
  | None, (Some _ | None) -> false

let ending job s results =
  if not (Jury.is_done s.jury) then Out_of_time
  else if not (Jury.all_met s.jury) then Out_of_samples
  else if is_contradicted job results then Misjudged
  else Met

let finish job s =
  let results = Jury.results job.rows s.jury in
  Some
    { results; ending = ending job s results; forecasts = List.rev s.forecasts }

(* {1 Rungs} *)

let per_doubling = 8

let mean_of_rung rung =
  float_of_int streams
  *. Float.exp2 (float_of_int rung /. float_of_int per_doubling)

(* The base is this share of all samples, or down to half of it. *)
let base_share = 0.5

let base_of_mean mean =
  let rec double n =
    let twice = 2 * n in
    if float_of_int twice <= base_share *. mean then double twice else n
  in
  double streams

(* {1 The base} *)

let squares job ~base x y =
  Row.squares job.rows.(y - job.window.y0) ~samples:base (x - job.window.x0)

let work job x y =
  Float.max 1. (Row.work job.rows.(y - job.window.y0) (x - job.window.x0))

let sum_of_squares job ~base =
  (* Local mutation: a sum over pixels. *)
  let sum = ref 0. in
  for y = job.window.y0 to job.window.y1 - 1 do
    for x = job.window.x0 to job.window.x1 - 1 do
      sum := !sum +. squares job ~base x y
    done
  done;
  !sum

(* Mean square errors go as n^-law, if known. A noisy estimate of it should not
   promise what is rare. *)
let law s =
  if s.before > 0. && s.squares > 0. then
    Some (Float.max 1. (Float.min 1.5 (Float.log2 (s.before /. s.squares))))
  else None

let allocation job ~base =
  Allocation.make job.window ~base ~cost:(work job) (squares job ~base)

(* All pixels have as many, and say how the others are shared out. So do those of
   parts that stopped: judges of others ask them. *)
let lay job s base =
  let* spent = pass job s.spent (fun _ _ -> base) in
  Some
    {
      s with
      mean = Float.max s.mean (float_of_int base);
      base;
      allocation = allocation job ~base;
      squares = sum_of_squares job ~base;
      before = s.squares;
      spent;
    }

(* {1 The others} *)

let share_out job s mean =
  let most = job.target.most and a = s.allocation in
  let scale part = Allocation.for_mean a (Part part) ~most mean in
  let scales = Array.init Part.count scale in
  let full part scale =
    let reached = Allocation.mean a (Part part) ~scale ~most in
    reached < mean *. (1. -. 0x1p-20)
  and needed = Array.init Part.count (Jury.is_needed s.jury) in
  let* spent =
    pass job s.spent (fun x y ->
        let part = Part.of_pixel x y in
        if needed.(part) then
          Allocation.samples a ~scale:scales.(part) ~most x y
        else 0)
  in
  Some (judge job { s with mean; full = Array.mapi full scales; spent })

(* {1 Forecasts} *)

(* The allocation knows how errors fall from here. *)
let total_for_error job s sampling error =
  let { confidence; most; _ } = job.target in
  let a = s.allocation and law = Option.value (law s) ~default:1. in
  match Sampling.upper ~confidence sampling with
  | Some upper when upper > 0. ->
      let scale =
        Allocation.for_mean a All ~most (s.spent.taken /. pixels job)
      in
      let now = Allocation.error a ~law ~scale ~most in
      let share = now *. error *. error /. (upper *. upper) in
      let scale = Allocation.for_error a ~law ~most share in
      Allocation.mean a All ~scale ~most *. pixels job
  | Some _ | None -> s.spent.taken

let next_rung job total =
  let rec from rung =
    let mean = mean_of_rung rung *. pixels job in
    if mean >= total || rung > Sys.int_size * per_doubling then mean
    else from (rung + 1)
  in
  from 0

(* As many as there is time for, where the allocation wants them. *)
let samples_left job s =
  let left = left job in
  if left > 0. then left /. (s.spent.rate *. Allocation.work s.allocation)
  else 0.

let forecast job s =
  let all = Jury.sampling job.rows and taken = s.spent.taken in
  let f =
    match job.target.error with
    | Some error ->
        let total = next_rung job (total_for_error job s all error) in
        Forecast.for_error ~law:(law s) all ~taken total
    | None -> Forecast.for_time all ~taken (taken +. samples_left job s)
  in
  job.expect f;
  { s with forecasts = f :: s.forecasts }

(* {1 The way to the target} *)

(* Less time is not worth another pass. *)
let is_over job =
  let enough = 0.01 in
  job.allowed < infinity && left job <= enough *. job.allowed

let is_done job s = is_over job || Jury.is_done s.jury

(* The samples a pixel that there is time for, if a share of it is spent: parts
   that nobody asks any more take none. *)
let affordable job s ~share =
  let needed = List.length (List.filter (Jury.is_needed s.jury) Part.all) in
  let part = float_of_int needed /. float_of_int Part.count in
  s.mean +. (share *. samples_left job s /. (part *. pixels job))

(* How long samples take is known when some are taken: so not all the time that
   is left at once, and less before those that go where they are needed. *)
let most_of_it = 0.8
let some_of_it = 0.25

(* What is left of the time. *)
let rec spend job s ~share =
  if is_done job s then finish job s
  else
    let before = s.spent.taken in
    let* s = share_out job s (affordable job s ~share) in
    if s.spent.taken > before then spend job s ~share:most_of_it
    else finish job s

(* Until the error is small enough. *)
let rec climb job s ~rung =
  if is_done job s then finish job s
  else
    let rung = rung + 1 in
    let mean = mean_of_rung rung in
    if affordable job s ~share:most_of_it < mean then
      spend job s ~share:most_of_it
    else
      let s = forecast job s in
      let base = base_of_mean mean in
      let* s =
        if s.base < base && base <= job.target.most then lay job s base
        else Some s
      in
      let* s = share_out job s mean in
      climb job s ~rung

(* The mean square error, as a share of the base's, that [work] beyond it is
   expected to leave. *)
let error_after job a ~work =
  let most = job.target.most in
  let more = work /. Allocation.work a /. pixels job in
  let mean = float_of_int (Allocation.base a) +. more in
  let scale = Allocation.for_mean a All ~most mean in
  Allocation.error a ~law:1. ~scale ~most

(* Who has a larger base knows better where samples are needed, but has fewer for
   those places: this much of the error is worth it. *)
let worth = 0.15

(* Whether to take so much [work] that the base, all that pixels have, is twice
   what it is, and still to leave as much for the others. *)
let may_broaden job s =
  let effort = s.spent.effort in
  let work = Float.max 0. (left job) /. s.spent.rate in
  (* Twice the samples leave half the squared error. *)
  let later () =
    let a = Allocation.with_base s.allocation (2 * s.base) in
    0.5 *. error_after job a ~work:(work -. effort)
  in
  2 * s.base <= job.target.most
  && 2. *. effort <= work
  && later () <= (1. +. worth) *. error_after job s.allocation ~work

(* While there is time for a larger base, for those who ask for no error. *)
let rec broaden job s =
  let s = forecast job s in
  let has_error = s.squares > 0. in
  if not has_error then finish job s
  else if may_broaden job s then
    let* s = lay job s (2 * s.base) in
    broaden job s
  else spend job s ~share:some_of_it

(* {1 The first samples} *)

(* As many as there is time for, in turns: each gives the pixels of one part a
   sample. The first tells how long samples take. The result is also whether
   there was time for all. *)
let begin_with job samples =
  let all = samples * Part.count in
  let first =
    List.filter (Part.is_in job.window) Part.all
    |> List.fold_left (fun least part -> Int.min least (Part.turn part + 1)) all
  in
  let wanted turns x y =
    let before = Part.turn (Part.of_pixel x y) in
    (turns - before + Part.count - 1) / Part.count
  in
  let rec take spent turns =
    let* spent = pass job spent (wanted turns) in
    let is_complete = spent.taken >= float_of_int samples *. pixels job in
    let more =
      if is_complete || is_over job then 0
      else
        let each = spent.rate *. spent.effort /. float_of_int turns in
        let affordable = most_of_it *. left job /. each in
        if affordable >= float_of_int (all - turns) then all - turns
        else if affordable >= 1. then int_of_float affordable
        else 0
    in
    if more = 0 then Some (spent, is_complete) else take spent (turns + more)
  in
  let none = { taken = 0.; effort = 0.; rate = 0. } in
  take none (if left job = infinity then all else first)

let start job spent =
  {
    mean = float_of_int streams;
    base = streams;
    allocation = allocation job ~base:streams;
    squares = sum_of_squares job ~base:streams;
    before = nan;
    full = Array.make Part.count false;
    jury = Jury.start job.window;
    spent;
    forecasts = [];
  }

let run window rows target ~pass ~expect =
  let job =
    { window; rows; target; pass; expect; allowed = time_left target }
  in
  let* spent, is_complete = begin_with job (Int.min streams target.most) in
  let stop ending =
    let results = Array.map Row.result job.rows in
    Some { results; ending; forecasts = [] }
  in
  if not is_complete then stop Out_of_time
  else if target.most < streams then stop Out_of_samples
  else
    let s = start job spent in
    if Option.is_some target.error then climb job (judge job s) ~rung:0
    else broaden job s
