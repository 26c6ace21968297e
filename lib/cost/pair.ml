open Candor_number
open Candor_image

type t = { first : Measure.t; second : Measure.t }

let half a b = (a +. b) /. 2.
let seconds p = half p.first.seconds p.second.seconds
let rays_per_pixel p = half p.first.rays_per_pixel p.second.rays_per_pixel
let count p = Float.Array.length p.first.times

(* The mean of [f] over the channels of pixel [i]. *)
let over_channels f i = (f (3 * i) +. f ((3 * i) + 1) +. f ((3 * i) + 2)) /. 3.
let over_pixels p f = Float.Array.init (count p) (over_channels f)

let mean values =
  Float.Array.fold_left ( +. ) 0. values
  /. float_of_int (Float.Array.length values)

let square x = x *. x

let squares (a : Measure.t) (b : Measure.t) j =
  square (Float.Array.get a.shown j -. Float.Array.get b.shown j)

let spread p = over_pixels p (fun j -> squares p.first p.second j /. 2.)

(* {1 Errors} *)

type error = { rms : float; p99 : float; pixels : Plane.t }

(* The least value that a share of all [values] do not exceed. *)
let percentile share values =
  let sorted = Float.Array.copy values in
  Float.Array.sort Float.compare sorted;
  let n = Float.Array.length sorted in
  let rank = int_of_float (Float.ceil (share *. float_of_int n)) in
  Float.Array.get sorted (Int.max 1 rank - 1)

let error ~finest p =
  let first = over_pixels p (squares p.first finest.second)
  and second = over_pixels p (squares p.second finest.first) in
  let raw = half (mean first) (mean second) in
  let clean = Float.max 0. (raw -. mean (spread finest)) in
  let kept = if raw > 0. then clean /. raw else 0. in
  let shown square = sqrt (kept *. square) in
  let width = Picture.width p.first.picture
  and height = Picture.height p.first.picture in
  let at i = half (Float.Array.get first i) (Float.Array.get second i) in
  {
    rms = sqrt clean;
    p99 =
      percentile 0.99 (Float.Array.map shown (Float.Array.append first second));
    pixels = Plane.init ~width ~height (fun i -> shown (at i));
  }

(* {1 Changes} *)

type change = {
  equal : bool;
  loss : float;
  bound : float;
  noisier : bool;
  quieter : bool;
  shows : bool;
}

type estimate = { value : float; deviation : float  (** its standard error *) }

let estimate values =
  let all =
    Float.Array.fold_left Running_variance.add Running_variance.empty values
  in
  let value = Option.value (Running_variance.mean all) ~default:0. in
  let deviation =
    match Running_variance.variance all with
    | Some v -> sqrt (v /. float_of_int (Running_variance.count all))
    | None -> infinity
  in
  { value; deviation }

(* Sums in another order round otherwise: less than this, in levels or their
   squares, is no change. *)
let dust = 0x1p-20

(* By how many standard errors it is off 0. *)
let score e = if Float.abs e.value < dust then 0. else e.value /. e.deviation
let same (a : Measure.t) (b : Measure.t) = Picture.equal a.picture b.picture
let sure = Normal.quantile 0.999
let likely = Normal.quantile 0.95

let moved values (a : Measure.t) (b : Measure.t) j =
  Float.Array.get (values a) j -. Float.Array.get (values b) j

let shown (m : Measure.t) = m.shown
let linear (m : Measure.t) = m.linear

(* Whether the mean changes. That is asked of linear light: the mean of what is
   displayed also changes with the noise. *)
let mean_changes ~base p =
  let first = moved linear p.first base.first
  and second = moved linear p.second base.second in
  let shifts channel =
    let at i = half (first ((3 * i) + channel)) (second ((3 * i) + channel)) in
    Float.abs (score (estimate (Float.Array.init (count p) at))) > sure
  in
  let common = estimate (over_pixels p (fun j -> first j *. second j)) in
  score common > sure || List.exists shifts [ 0; 1; 2 ]

let change ~base p =
  let first = moved shown p.first base.first
  and second = moved shown p.second base.second in
  let common = estimate (over_pixels p (fun j -> first j *. second j)) in
  let noise =
    score (estimate (Float.Array.map2 ( -. ) (spread p) (spread base)))
  in
  let root x = sqrt (Float.max 0. x) in
  let noisier = noise > sure in
  {
    equal = same p.first base.first && same p.second base.second;
    loss = root common.value;
    bound = root (Float.max 0. common.value +. (likely *. common.deviation));
    noisier;
    quieter = noise < -.sure;
    shows = noisier || mean_changes ~base p;
  }

let wrong ~base p =
  let first = moved shown p.first base.first
  and second = moved shown p.second base.second in
  let far j =
    (first j >= 1. && second j >= 1.) || (first j <= -1. && second j <= -1.)
  in
  let is_wrong i = far (3 * i) || far ((3 * i) + 1) || far ((3 * i) + 2) in
  List.length (List.filter is_wrong (List.init (count p) Fun.id))
