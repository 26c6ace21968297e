open Candor_number
open Candor_colour
open Candor_sample
open Candor_trace

type t = {
  values : int; (* pixels times channels *)
  unknown : bool;
  quarter : float; (* J: sums of squares when a stream is left out *)
  half : float; (* H: when two are *)
  fourth : float; (* of the squares of each pixel's J *)
}

let none = { values = 0; unknown = false; quarter = 0.; half = 0.; fourth = 0. }

let join a b =
  {
    values = a.values + b.values;
    unknown = a.unknown || b.unknown;
    quarter = a.quarter +. b.quarter;
    half = a.half +. b.half;
    fourth = a.fourth +. b.fourth;
  }

(* {1 From samples} *)

let streams = Sampler.streams
let all_streams = List.init streams Fun.id

let pairs =
  List.concat_map
    (fun i ->
      List.filter_map (fun j -> if i < j then Some (i, j) else None) all_streams)
    all_streams

let size ~samples stream = (samples - stream + streams - 1) / streams

(* Rounding leaves less than this of numbers up to 255 that are alike. *)
let rounding = 0x1p-40

(* What the squared change is worth when a share [w] of the samples is left out:
   right on average, were the display linear. *)
let worth ~out:w change = (1. -. w) /. w *. change *. change
let all_equal xs = Array.for_all (Float.equal xs.(0)) xs

(* One channel, from each stream's sum and share of the samples. *)
let channel ~samples ~sums ~shares =
  let n = float_of_int samples in
  let total = Array.fold_left ( +. ) 0. sums in
  let shown = Display.encode (total /. n) in
  let without sum share =
    let change =
      Display.encode ((total -. sum) /. (n *. (1. -. share))) -. shown
    in
    if Float.abs change < rounding then 0. else worth ~out:share change
  in
  let one i = without sums.(i) shares.(i)
  and two (i, j) = without (sums.(i) +. sums.(j)) (shares.(i) +. shares.(j)) in
  let add f sum x = sum +. f x in
  ( List.fold_left (add (fun i -> shares.(i) *. one i)) 0. all_streams,
    List.fold_left (add two) 0. pairs /. float_of_int (List.length pairs) )

let pixel sums at ~samples =
  if samples < streams then { none with values = 3; unknown = true }
  else
    let shares =
      Array.init streams (fun i ->
          float_of_int (size ~samples i) /. float_of_int samples)
    in
    let finite = ref true in
    let of_channel k =
      let sums =
        Array.init streams (fun stream ->
            Running_sum.total (Pixel.stream_sum sums at ~stream ~channel:k))
      in
      if not (Array.for_all Float.is_finite sums) then finite := false;
      if all_equal sums && all_equal shares then (0., 0.)
      else channel ~samples ~sums ~shares
    in
    let r, r' = of_channel 0
    and g, g' = of_channel 1
    and b, b' = of_channel 2 in
    let quarter = r +. g +. b in
    {
      values = 3;
      unknown = not !finite;
      quarter;
      half = r' +. g' +. b';
      fourth = quarter *. quarter;
    }

let squares s = s.quarter

(* {1 What it says} *)

(* Where only leaving out two streams changes anything, what leaving out none
   would is anybody's guess. *)
let known s = s.values > 0 && (not s.unknown) && (s.quarter > 0. || s.half = 0.)

let straightened s =
  if s.half > 0. then s.quarter *. sqrt (s.quarter /. s.half) else s.quarter

let mean_square s =
  if known s then Some (straightened s /. float_of_int s.values) else None

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
