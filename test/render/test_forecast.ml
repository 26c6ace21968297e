open Candor_render
open Candor_oracle
open QCheck2

(* A pixel of four streams that differ so much, many times. *)
let sampling ~differ ~doublings =
  let sums = Float.Array.make Candor_trace.Pixel.slots 0. in
  List.iteri
    (fun i x ->
      for channel = 0 to 2 do
        Candor_number.Running_sum.accumulate sums
          ((6 * i) + (2 * channel))
          (0.5 +. (differ *. x))
      done)
    [ -1.; 0.3; 0.9; -0.2 ];
  let rec doubled n s =
    if n = 0 then s else doubled (n - 1) (Sampling.join s s)
  in
  doubled doublings (Sampling.pixel sums 0 ~samples:4)

type case = {
  law : float option;
  differ : float;
  doublings : int;
  taken : float;
  total : float;
}

let case =
  let open Gen in
  let* law = option (Draw.uniform 1. 1.5)
  and* differ = Draw.pick [ 0.; 0.001; 0.1 ]
  and* doublings = Draw.pick [ 0; 7; 20 ]
  and* taken = Draw.uniform 0. 1e4 in
  let+ total = Draw.uniform 0. 1e6 in
  { law; differ; doublings; taken; total }

let print c =
  Printf.sprintf "law %s, differ %g, 2^%d pixels, %g taken, %g in all"
    (Option.fold ~none:"unknown" ~some:string_of_float c.law)
    c.differ c.doublings c.taken c.total

let law name f = Law.law ~print name case f

let both c =
  let s = sampling ~differ:c.differ ~doublings:c.doublings in
  [
    Forecast.for_error ~law:c.law s ~taken:c.taken c.total;
    Forecast.for_time s ~taken:c.taken c.total;
  ]

let in_order c =
  List.for_all
    (fun (f : Forecast.t) ->
      f.taken = c.taken && f.taken <= f.low && f.low <= f.total
      && f.total <= f.high)
    (both c)

(* With a law that was found, what was reckoned with it is what is said. *)
let as_reckoned c =
  let s = sampling ~differ:c.differ ~doublings:c.doublings in
  let law = Some (Option.value c.law ~default:1.2) in
  let f = Forecast.for_error ~law s ~taken:c.taken c.total in
  let expected = Float.max c.taken c.total in
  Float.abs (f.total -. expected) <= 1e-9 *. expected
  || Law.fail "%g instead of %g" f.total expected

let width (f : Forecast.t) = f.high /. f.low

(* The better an error is known, the better is what follows from it. *)
let surer c =
  let forecast ~law doublings =
    let s = sampling ~differ:0.1 ~doublings in
    Forecast.for_error ~law s ~taken:1. (10. +. c.total)
  in
  let law = Some 1.25 in
  width (forecast ~law 20) < width (forecast ~law 3)
  && width (forecast ~law 20) < width (forecast ~law:None 20)

let suite =
  ( "forecasts",
    [
      law "what was taken, low, total and high are in order" in_order;
      law "with a known law the total is as reckoned" as_reckoned;
      law "knowing more makes it surer" surer;
    ] )
