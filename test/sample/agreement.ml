(** Whether samples have the density that is stated for them: counts in cells
    against integrals of the density over the cells. *)

open Candor_space
open Candor_sample

let cases = 100_000

(** [position i] is place [i] of many independent ones in the unit square. *)
let position i =
  let number k = Key.float (Key.v ~seed:k ~x:i ~y:7 ~sample:0 ~bounce:0 Film) in
  { Pattern.u = number 1; v = number 2 }

let close name ~within expected value =
  if not (Float.abs (value -. expected) <= within *. Float.abs expected) then
    Alcotest.failf "%s: %.17g, not %.17g" name value expected

(* Which of the stretches between the rising [edges] holds x; outside of all it
   is the nearest. *)
let stretch edges x =
  let rec find i =
    if i + 2 < Array.length edges && x >= edges.(i + 1) then find (i + 1) else i
  in
  find 0

(** [line name edges ~sample ~density] compares [sample u] with the integrals of
    [density] between [edges], the first and the last of which bound all; they
    must add up to 1. *)
let line name edges ~sample ~density =
  let cells = Array.length edges - 1 in
  let mass i = Quadrature.integral density edges.(i) edges.(i + 1) in
  let expected = Array.init cells mass in
  close (name ^ ", all of it") ~within:1e-6 1.
    (Array.fold_left ( +. ) 0. expected);
  let bin i = stretch edges (sample (position i).u) in
  Chi_square.(against name expected (count cells cases bin))

(** [steps n a b] is n + 1 numbers from [a] to [b]. *)
let steps n a b =
  Array.init (n + 1) (fun i ->
      a +. ((b -. a) *. float_of_int i /. float_of_int n))

let sectors = 16
let turn = 2. *. Float.pi

(* The sector of the azimuth. *)
let sector (d : Vec.t) =
  let a = Float.atan2 d.y d.x /. turn in
  let a = if a < 0. then a +. 1. else a in
  Int.min (sectors - 1) (int_of_float (a *. float_of_int sectors))

let direction z azimuth =
  let s = sqrt (Float.max 0. ((1. -. z) *. (1. +. z))) in
  Vec.v (s *. cos azimuth) (s *. sin azimuth) z

(** [sphere name edges ~sample ~density] compares the directions [sample p] with
    the integrals of [density] over zones between the heights [edges], from -1
    to 1, each cut into sectors. *)
let sphere name edges ~sample ~density =
  let zones = Array.length edges - 1 in
  let mass i =
    let z = i / sectors in
    let from = turn /. float_of_int sectors *. float_of_int (i mod sectors) in
    Quadrature.over_rectangle
      (fun z a -> density (Option.get (Dir.of_vec (direction z a))))
      (edges.(z), edges.(z + 1))
      (from, from +. (turn /. float_of_int sectors))
  in
  let expected = Array.init (zones * sectors) mass in
  close (name ^ ", all of it") ~within:1e-4 1.
    (Array.fold_left ( +. ) 0. expected);
  let bin i =
    let d = (sample (position i) : Dir.t :> Vec.t) in
    (stretch edges d.z * sectors) + sector d
  in
  Chi_square.(against name expected (count (zones * sectors) cases bin))
