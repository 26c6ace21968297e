open Candor_number
open Candor_colour
open Candor_sample
open Candor_trace

(* Floats alone, so that they lie side by side. *)
type t = {
  values : float; (* pixels times channels *)
  unknown : float; (* pixels that tell nothing *)
  quarter : float; (* J: sums of squares when a stream is left out *)
  half : float; (* H: when two are *)
  fourth : float; (* of the squares of each pixel's J *)
}

let none = { values = 0.; unknown = 0.; quarter = 0.; half = 0.; fourth = 0. }
let channels = 3
let unknown = { none with values = float_of_int channels; unknown = 1. }

let join a b =
  {
    values = a.values +. b.values;
    unknown = a.unknown +. b.unknown;
    quarter = a.quarter +. b.quarter;
    half = a.half +. b.half;
    fourth = a.fourth +. b.fourth;
  }

let sum f xs = Array.fold_left (fun sum x -> join sum (f x)) none xs

(* {1 From samples} *)

let streams = Sampler.streams
let size ~samples stream = (samples - stream + streams - 1) / streams

(* Rounding leaves less than this of numbers up to 255 that are alike. *)
let rounding = 0x1p-40

(* What is shown without a sum of so many samples, less what is [shown]. *)
let[@inline] change ~shown ~all ~samples sum n =
  let change =
    Display.encode ((all -. sum) /. float_of_int (samples - n)) -. shown
  in
  if Float.abs change < rounding then 0. else change

(* What the squared change is worth when a share [w] of the samples is left out:
   right on average, were the display linear. *)
let[@inline] worth ~out:w change = (1. -. w) /. w *. change *. change

let[@inline] stream_sum sums at i k =
  Running_sum.total (Pixel.stream_sum sums at ~stream:i ~channel:k)

let[@inline] share n samples = float_of_int n /. float_of_int samples

(* Of one channel, when one stream is left out. *)
let quarter sums at ~samples ~all ~shown k =
  let sum = ref 0. in
  for i = 0 to streams - 1 do
    let n = size ~samples i in
    let c = change ~shown ~all ~samples (stream_sum sums at i k) n in
    let w = share n samples in
    sum := !sum +. (w *. worth ~out:w c)
  done;
  !sum

let pairs = streams * (streams - 1) / 2

(* When two are. *)
let half sums at ~samples ~all ~shown k =
  let sum = ref 0. in
  for i = 0 to streams - 1 do
    for j = i + 1 to streams - 1 do
      let n = size ~samples i + size ~samples j in
      let pair = stream_sum sums at i k +. stream_sum sums at j k in
      let c = change ~shown ~all ~samples pair n in
      sum := !sum +. worth ~out:(share n samples) c
    done
  done;
  !sum /. float_of_int pairs

let all_equal sums at ~samples k =
  let first = stream_sum sums at 0 k in
  let rec from i =
    i = streams || (Float.equal first (stream_sum sums at i k) && from (i + 1))
  in
  samples mod streams = 0 && from 1

let pixel sums at ~samples =
  if samples < streams then unknown
  else
    (* Local mutation: three sums over channels. *)
    let j = ref 0. and h = ref 0. and finite = ref true in
    for k = 0 to channels - 1 do
      let all = ref 0. in
      for i = 0 to streams - 1 do
        all := !all +. stream_sum sums at i k
      done;
      let all = !all in
      if not (Float.is_finite all) then finite := false
      else if not (all_equal sums at ~samples k) then (
        let shown = Display.encode (all /. float_of_int samples) in
        j := !j +. quarter sums at ~samples ~all ~shown k;
        h := !h +. half sums at ~samples ~all ~shown k)
    done;
    if !finite then
      {
        values = float_of_int channels;
        unknown = 0.;
        quarter = !j;
        half = !h;
        fourth = !j *. !j;
      }
    else unknown

let squares s = if s.quarter > 0. then s.quarter else s.half
let tells_nothing s = s.unknown > 0.

(* {1 What it says} *)

(* Where only leaving out two streams changes anything, what leaving out none
   would is anybody's guess. *)
let known s = s.values > 0. && s.unknown = 0. && (s.quarter > 0. || s.half = 0.)

let straightened s =
  if s.half > 0. then s.quarter *. sqrt (s.quarter /. s.half) else s.quarter

let mean_square s = if known s then Some (straightened s /. s.values) else None
let rms s = Option.map sqrt (mean_square s)

(* The deviation of ln of the mean square: of the four streams' products, for
   which 8/5 of the fourth powers is enough, and of the display's bend. *)
let deviation s =
  if s.quarter > 0. then
    Float.hypot
      (sqrt (8. /. 5. *. s.fourth) /. s.quarter)
      ((s.quarter -. s.half) /. straightened s)
  else 0.

type interval = { low : float; high : float }

let times_exp rms k deviation = rms *. exp (0.5 *. k *. deviation)

let interval ~confidence s =
  let k = Normal.quantile (0.5 *. (1. +. confidence)) in
  let around rms =
    {
      low = times_exp rms (-.k) (deviation s);
      high = times_exp rms k (deviation s);
    }
  in
  Option.map around (rms s)

let upper ~confidence s =
  let k = Normal.quantile confidence in
  Option.map (fun rms -> times_exp rms k (deviation s)) (rms s)

(* Half a deviation more: who stops at the first of many looks that says so
   stops a little early. *)
let cautious ~confidence s =
  let d = deviation s in
  let k = Normal.quantile confidence +. (0.5 *. d) in
  Option.map (fun rms -> times_exp rms k d) (rms s)
