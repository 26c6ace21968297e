open Candor_sample

type target = {
  error : float option;
  confidence : float;
  left : (unit -> float) option;
  most : int;
}

type forecast = { taken : float; total : float; low : float; high : float }
type ending = Met | Out_of_time | Out_of_samples

type outcome = {
  results : Row.result array;
  ending : ending;
  forecasts : forecast list;
}

type job = {
  rows : Row.t array;
  target : target;
  pass : (int -> int -> int) -> Row.result array option;
  expect : forecast -> unit;
}

(* What is done so far. *)
type state = {
  results : Row.result array;
  base : int; (* samples that every pixel has *)
  sampling : Sampling.t;
  law : float; (* the mean square error goes as n^-law *)
  taken : float; (* samples *)
  rate : float; (* seconds for each of the last *)
  evenly : bool; (* whether all pixels had as many of the last *)
  forecasts : forecast list; (* last first *)
}

let width job = Row.width job.rows.(0)
let height job = Array.length job.rows
let pixels job = float_of_int (width job * height job)

let left job =
  match job.target.left with Some left -> left () | None -> infinity

let upper job s = Sampling.upper ~confidence:job.target.confidence s.sampling

let is_met job s =
  match (job.target.error, upper job s) with
  | Some error, Some upper -> upper <= error
  | Some _, None | None, _ -> false

(* {1 Passes} *)

let count results =
  let of_row n (r : Row.result) = n + Array.fold_left ( + ) 0 r.counts in
  float_of_int (Array.fold_left of_row 0 results)

let pass job s wanted =
  let before = left job in
  let after results =
    let taken = count results in
    let more = taken -. s.taken in
    let add sum (r : Row.result) = Sampling.join sum r.sampling in
    {
      s with
      results;
      sampling = Array.fold_left add Sampling.none results;
      taken;
      rate =
        (if before < infinity && more > 0. then (before -. left job) /. more
         else s.rate);
    }
  in
  Option.map after (job.pass wanted)

(* Independent samples have law 1, those that fill their space evenly more; a
   noisy estimate of it should not promise what is rare. *)
let law_between before after =
  let ratio = float_of_int after.base /. float_of_int before.base in
  match
    (Sampling.mean_square before.sampling, Sampling.mean_square after.sampling)
  with
  | Some a, Some b when a > 0. && b > 0. && ratio > 1. ->
      Float.max 1. (Float.min 1.5 (Float.log (a /. b) /. Float.log ratio))
  | (Some _ | None), (Some _ | None) -> before.law

let lay job s base =
  let after next =
    let next = { next with base; evenly = true } in
    { next with law = law_between s next }
  in
  Option.map after (pass job s (fun _ _ -> base))

(* {1 How many samples are wanted} *)

let allocation job s =
  let squares x y =
    if s.base < Sampler.streams then 1.
    else
      let row = job.rows.(y) in
      let more = float_of_int (Row.samples row x) /. float_of_int s.base in
      Sampling.squares (Row.sampling row x) *. (more ** s.law)
  in
  Allocation.make ~width:(width job) ~height:(height job) ~base:s.base squares

(* The share of the mean square error that may be left. *)
let share_wanted job s error =
  match upper job s with
  | Some upper when upper > 0. -> error *. error /. (upper *. upper)
  | Some _ | None -> 0.

let scale_for_error job s allocation =
  match job.target.error with
  | None -> infinity
  | Some error ->
      Allocation.for_error allocation ~law:s.law ~most:job.target.most
        (share_wanted job s error)

(* The scale that takes a share of the time that is left. *)
let scale_for_time job s allocation ~share =
  let left = left job in
  if left = infinity then infinity
  else
    let more = if left > 0. then share *. left /. s.rate else 0. in
    Allocation.for_total allocation ~most:job.target.most (s.taken +. more)

(* {1 Forecasts} *)

let spread s =
  match
    (Sampling.rms s.sampling, Sampling.interval ~confidence:0.95 s.sampling)
  with
  | Some rms, Some { high; _ } when rms > 0. -> (high /. rms) ** (2. /. s.law)
  | (Some _ | None), (Some _ | None) -> 2.

(* [total] was reckoned with the law of [s]. *)
let total_by s ~total law =
  if total > s.taken && s.taken > 0. then
    s.taken *. ((total /. s.taken) ** (s.law /. law))
  else total

(* Before the law was measured it may be almost any, and the least samples often
   miss what makes the error: so it is more likely larger than they say than
   smaller. *)
let forecast job s ~total =
  let total = Float.max s.taken total in
  let spread = spread s and by = total_by s ~total in
  let total, low, high =
    if Option.is_none job.target.error then
      (total, total /. spread, total *. spread)
    else if s.base > Sampler.streams then
      let flat = Float.max 1. (s.law -. 0.25) in
      (by s.law, by (s.law +. 0.25) /. spread, by flat *. spread)
    else (by 1.25, by 2. /. spread, by 1. *. (spread ** 3.))
  in
  let f = { taken = s.taken; total; low = Float.max s.taken low; high } in
  job.expect f;
  { s with forecasts = f :: s.forecasts }

(* {1 The way to the target} *)

let finish (s : state) ending =
  Some { results = s.results; ending; forecasts = List.rev s.forecasts }

let ( let* ) = Option.bind

(* By how much all shares must grow if the target was missed. *)
let growth job s =
  match job.target.error with
  | None -> infinity
  | Some error ->
      let share = share_wanted job s error in
      if share > 0. then Float.max 1.01 (share ** (-1. /. s.law)) else 2.

(* Less time than this is not worth another pass. *)
let enough_time = 0.01

(* What few samples say is doubtful, and samples that fill their space evenly
   are worth more than they say: so most of what seems to be missing is taken,
   and looked at. *)
let step = 0.6

let step_towards job s allocation ~total ~scale =
  let missing = total -. s.taken in
  if missing <= (1. -. step) *. s.taken then scale
  else
    Allocation.for_total allocation ~most:job.target.most
      (s.taken +. (step *. missing))

(* The base is this share of all samples, or down to half of it. *)
let base_share = 0.5

let next_base job s ~wanted =
  let goal =
    Float.min
      (base_share *. wanted /. pixels job)
      (float_of_int job.target.most)
  in
  let rec double n =
    if float_of_int (2 * n) <= goal then double (2 * n) else n
  in
  Int.min (4 * s.base) (double s.base)

(* Not all the time that is left at once. Samples that go where they are needed
   may take much longer than others: how long is known when some are taken. *)
let time_share s = if s.evenly then 0.25 else 0.8

(* If more than so many times the samples are still missing, the allocation does
   not know where the error is: a pixel unlike all its neighbours, who ask for
   nothing, has what every pixel has. *)
let missed = 2.

let raise_base job s =
  let base = Int.min (2 * s.base) (Int.max s.base job.target.most) in
  Option.map
    (fun s -> { s with base; evenly = true })
    (pass job s (fun _ _ -> base))

(* [allowed] is how many seconds there were in the beginning. *)
let rec spend job s allocation ~scale ~allowed =
  if is_met job s then finish s Met
  else if allowed < infinity && left job <= enough_time *. allowed then
    finish s Out_of_time
  else
    let most = job.target.most in
    let in_time = scale_for_time job s allocation ~share:(time_share s) in
    let expected =
      Allocation.total allocation ~scale:(Float.min scale in_time) ~most
    in
    let s = forecast job s ~total:expected in
    let scale =
      if scale < infinity then
        step_towards job s allocation ~total:expected ~scale
      else scale
    in
    let scale = Float.min scale in_time in
    let before = s.taken in
    let* s = pass job s (Allocation.samples allocation ~scale ~most) in
    let s = { s with evenly = false } in
    let growth = growth job s in
    if s.taken > before && growth > missed && scale < in_time then
      let* s = raise_base job s in
      lay_base job s ~allowed
    else if s.taken > before then
      spend job s allocation ~scale:(scale *. growth) ~allowed
    else if left job < infinity then finish s Out_of_time
    else finish s Out_of_samples

and lay_base job s ~allowed =
  if is_met job s then finish s Met
  else
    let allocation = allocation job s in
    let scale =
      Float.min
        (scale_for_error job s allocation)
        (scale_for_time job s allocation ~share:1.)
    in
    let wanted = Allocation.total allocation ~scale ~most:job.target.most in
    let base = next_base job s ~wanted in
    if base > s.base then
      let* s = lay job (forecast job s ~total:wanted) base in
      lay_base job s ~allowed
    else spend job s allocation ~scale ~allowed

let start =
  {
    results = [||];
    base = 0;
    sampling = Sampling.none;
    law = 1.;
    taken = 0.;
    rate = 0.;
    evenly = true;
    forecasts = [];
  }

(* The first sample tells how long samples take; the fourth, the error. *)
let run rows target ~pass ~expect =
  let job = { rows; target; pass; expect } in
  let allowed = left job in
  let* s = lay job start 1 in
  let streams = Sampler.streams in
  let fits = left job >= float_of_int (streams - 1) *. pixels job *. s.rate in
  if target.most >= streams && fits then
    let* s = lay job s streams in
    lay_base job s ~allowed
  else lay_base job s ~allowed
