(* What a picture should show, known from many more samples than it has.

   It is known twice, independently. The product of a picture's differences from
   both is the square of its error, on average: what chance did to the one half
   has nothing to do with the other. *)

open Candor_colour

type t = { halves : floatarray * floatarray }

(* No render that is judged has these seeds. *)
let seeds = (1_000_001, 1_000_002)
let shown results = Float.Array.map Display.encode (Shot.linear results)

(** [v scene ~spp] has [spp] samples in each pixel of each half. *)
let v scene ~spp =
  let half seed = shown (Shot.uniform scene seed spp) in
  { halves = (half (fst seeds), half (snd seeds)) }

(** [mean_square t results] is the mean over pixels and channels of the square
    of what the picture of [results] shows wrong, in units of (1/255)². *)
let mean_square { halves = a, b } results =
  let p = shown results in
  let n = Float.Array.length p in
  let sum = ref 0. in
  for i = 0 to n - 1 do
    let x = Float.Array.get p i in
    let x_a = x -. Float.Array.get a i and x_b = x -. Float.Array.get b i in
    sum := !sum +. (x_a *. x_b)
  done;
  !sum /. float_of_int n

(** [error t results] is its root. *)
let error t results = sqrt (Float.max 0. (mean_square t results))
