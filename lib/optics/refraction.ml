open Candor_number
open Candor_space

type boundary = { from : float; into : float }

let reverse b = { from = b.into; into = b.from }
let clamp c = if c < 0. then 0. else if c > 1. then 1. else c

let exact_discriminant b c =
  let open Expansion in
  let square x = mul x x in
  let incoming = mul (of_float b.from) (of_float c) in
  to_float
    (add
       (sub (square (of_float b.into)) (square (of_float b.from)))
       (square incoming))

(* (from c)^2 - (from - into)(from + into): the difference of the rounded
   products, and what rounding took from their factors. Where the products are
   close, what this neglects is below 2^-102 of either. *)
let discriminant b c =
  let c = clamp c in
  let e = b.from *. c and less = b.from -. b.into and more = b.from +. b.into in
  let e' = Error_free.product_error b.from c e
  and less' = Error_free.sum_error b.from (-.b.into) less
  and more' = Error_free.sum_error b.from b.into more in
  let rest = (2. *. e *. e') -. ((less *. more') +. (less' *. more)) in
  let d = Error_free.difference_of_products e e less more +. rest in
  if Float.abs d <= 0x1p-40 *. e *. e then exact_discriminant b c else d

(* What follows is for media that differ, incoming cosine [c] and the root r of
   a discriminant that is not negative. With e = from c, the difference e - r is
   (from^2 - into^2)/(e + r), where nothing cancels. *)

let[@inline] difference b = (b.from -. b.into) *. (b.from +. b.into)
let[@inline] sum b c r = (b.from *. c) +. r

(* One polarisation has the amplitude (e - r)/(e + r), the other that times
   cos(a + a')/cos(a - a') for the angles a and a' of incidence and refraction:
   where the latter cancels, it does not matter beside the former. *)
let partial_reflectance b c r =
  let sum = sum b c r in
  let amplitude = difference b /. (sum *. sum) in
  let cosines = c *. r and sines = b.from *. (1. -. c) *. (1. +. c) in
  let other = (cosines -. sines) /. (cosines +. sines) in
  let reflected = 0.5 *. amplitude *. amplitude *. (1. +. (other *. other)) in
  if reflected > 1. then 1. else reflected

let direction b ~(normal : Dir.t) (d : Dir.t) c r =
  let along = b.from /. b.into
  and aside = difference b /. (sum b c r *. b.into) in
  let v =
    Vec.add (Vec.scale along (d :> Vec.t)) (Vec.scale aside (normal :> Vec.t))
  in
  Dir.of_vec_or d v

let reflectance b c =
  if b.from = b.into then 0.
  else
    let c = clamp c in
    let k = discriminant b c in
    if k < 0. then 1. else partial_reflectance b c (sqrt k)

type t =
  | Total_reflection
  | Transmitted of { direction : Dir.t; reflectance : float }

let at b ~normal d =
  if b.from = b.into then Transmitted { direction = d; reflectance = 0. }
  else
    let c = clamp (-.Dir.dot normal d) in
    let k = discriminant b c in
    if k < 0. then Total_reflection
    else
      let r = sqrt k in
      Transmitted
        {
          direction = direction b ~normal d c r;
          reflectance = partial_reflectance b c r;
        }
