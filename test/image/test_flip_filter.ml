open Candor_image
open Support
open QCheck2

let ppd = Gen.float_range 1. 400.
let sum = Float.Array.fold_left ( +. ) 0.
let one x = Float.abs (x -. 1.) < 1e-12
let those holds row = List.filter holds (Float.Array.to_list row)
let total weights = List.fold_left ( +. ) 0. weights

let blurs_sum_to_one ppd =
  let area rows =
    List.fold_left (fun s row -> s +. (sum row *. sum row)) 0. rows
  in
  List.for_all
    (fun blur -> one (area (blur ~ppd)))
    Flip_filter.[ achromatic; red_green; blue_yellow ]

let features_balance ppd =
  let balanced row =
    one (total (those (fun w -> w > 0.) row))
    && one (-.total (those (fun w -> w < 0.) row))
  in
  one (sum (Flip_filter.smooth ~ppd))
  && balanced (Flip_filter.edge ~ppd)
  && balanced (Flip_filter.point ~ppd)

let reach ppd =
  let radius row = Float.Array.length row / 2 in
  let rows =
    Flip_filter.(
      achromatic ~ppd @ red_green ~ppd @ blue_yellow ~ppd
      @ [ smooth ~ppd; edge ~ppd; point ~ppd ])
  in
  List.for_all (fun row -> Float.Array.length row land 1 = 1) rows
  && List.fold_left Int.max 0 (List.map radius rows) = Flip_filter.reach ~ppd

(* 3 standard deviations: of the widest blur √(0.04/(2π²)) degrees, of the
   detector 0.041. *)
let published () =
  let ppd = Flip.default_ppd in
  let radius row = Float.Array.length row / 2 in
  Alcotest.(check int) "reach" 10 (Flip_filter.reach ~ppd);
  Alcotest.(check int) "detector" 9 (radius (Flip_filter.edge ~ppd))

let tests =
  [
    unit "kernels are as wide as published" published;
    law "a blur keeps what is even" ppd blurs_sum_to_one;
    law "detectors answer nothing to what is even, and one to a step" ppd
      features_balance;
    law "nothing is looked at beyond the reach" ppd reach;
  ]

let suite = ("flip_filter", tests)
