(* |t| > s with probability I_x(dof/2, 1/2), where x/(1 - x) is dof/s². *)
let beta dof odds = Incomplete.beta (dof /. 2.) 0.5 ~odds

(* The first term of a series that has no other while x is small: x^a/(a B). The
   slope at x = 1/2 is 2^-(a + b)/B. *)
let far dof tails =
  let a = dof /. 2. in
  let factor = Float.exp2 (a +. 0.5) *. (beta dof 1.).slope /. a in
  let root x = x ** (1. /. dof) in
  sqrt dof *. root factor /. root tails

(* The first terms of the expansion about the normal distribution, by R. A.
   Fisher, E. A. Cornish, 1960: no others count for so many degrees. *)
let almost_normal dof p =
  let z = Normal.quantile p in
  if Float.is_finite z then z +. (z *. ((z *. z) +. 1.) /. (4. *. dof)) else z

(* The t > 0 that is exceeded with probability 0 < p <= 1/2. *)
let upper dof p =
  let tails = 2. *. p in
  if tails ** (1. /. dof) < 0x1p-30 then far dof tails
  else sqrt (dof /. Incomplete.inverse (beta dof) ~start:dof tails)

let quantile ~dof p =
  if not (dof >= 1. && p >= 0. && p <= 1.) then nan
  else if p = 0. then neg_infinity
  else if p = 1. then infinity
  else if dof > Incomplete.most then almost_normal dof p
  else if p <= 0.5 then -.upper dof p
  else upper dof (1. -. p)
