type t = { lower : float; upper : float; slope : float }

let most = 0x1p40
let valid a = a >= 0.5 && a <= most
let undefined = { lower = nan; upper = nan; slope = nan }

(* The value that going twice as deep leaves as it is. The deepest is beyond
   what the largest parameters need. *)
let settled value =
  let rec go depth previous =
    let v = value depth in
    if Float.equal v previous || depth >= 0x4000000 then v else go (2 * depth) v
  in
  go 32 (value 16)

(* Stirling's, in powers of 1/a². *)
let series =
  [
    1. /. 12.;
    -1. /. 360.;
    1. /. 1260.;
    -1. /. 1680.;
    1. /. 1188.;
    -691. /. 360360.;
    1. /. 156.;
  ]

(* log Γ(a + 1) - log (√(2πa) (a/e)^a). *)
let rec stirling a =
  if a < 12. then stirling (a +. 1.) +. ((a +. 0.5) *. log1p (1. /. a)) -. 1.
  else
    let r = 1. /. (a *. a) in
    List.fold_right (fun c rest -> c +. (r *. rest)) series 0. /. a

(* k log (k / m) + m - k, where off = k - m; near 0 by the series of atanh. *)
let deviance k m ~off =
  let v = off /. (k +. m) in
  let rec series sum term odd =
    let term = term *. v *. v in
    let next = sum +. (term /. odd) in
    if Float.equal next sum then sum else series next term (odd +. 2.)
  in
  if Float.abs v < 0.1 then series (off *. v) (2. *. k *. v) 3.
  else
    let log_ratio = if m < k then -.log (m /. k) else log (k /. m) in
    (k *. log_ratio) -. off

let tau = 2. *. Float.pi

(* x^a e^-x / Γ(a). *)
let gamma_slope a x =
  sqrt (a /. tau) *. exp (-.stirling a -. deviance a x ~off:(a -. x))

(* 1 + x/(a + 1) (1 + x/(a + 2) (1 + ...)). *)
let gamma_series a x depth =
  let rec go k sum =
    if k = 0 then sum else go (k - 1) (1. +. (x /. (a +. float_of_int k) *. sum))
  in
  go depth 1.

(* x + 1 - a - 1 (1 - a)/(x + 3 - a - 2 (2 - a)/(x + 5 - a - ...)). *)
let gamma_fraction a x depth =
  let off = x -. a in
  let rec go k rest =
    let m = float_of_int k in
    let here = off +. (2. *. m) +. 1. in
    let rest = here -. ((m +. 1.) *. (m +. 1. -. a) /. rest) in
    if k = 0 then rest else go (k - 1) rest
  in
  go depth (off +. (2. *. float_of_int depth) +. 3.)

let gamma a x =
  if not (valid a && x >= 0.) then undefined
  else if x = infinity then { lower = 1.; upper = 0.; slope = 0. }
  else
    let slope = gamma_slope a x in
    if slope = 0. then
      if x < a then { lower = 0.; upper = 1.; slope }
      else { lower = 1.; upper = 0.; slope }
    else if x < a +. 1. then
      let lower = slope /. a *. settled (gamma_series a x) in
      { lower; upper = 1. -. lower; slope }
    else
      let upper = slope /. settled (gamma_fraction a x) in
      { lower = 1. -. upper; upper; slope }

(* x^a y^b / B(a, b), where off = a y - b x. *)
let beta_slope a b x y ~off =
  let n = a +. b in
  let fit = stirling n -. stirling a -. stirling b in
  let deviance = deviance a (n *. x) ~off +. deviance b (n *. y) ~off:(-.off) in
  sqrt (a /. n *. b /. tau) *. exp (fit -. deviance)

(* What divides the slope: b_0 + a_1/(b_1 + a_2/(b_2 + ...)). *)
let beta_fraction a b x y ~off depth =
  let whole m =
    let odd = a +. (2. *. m) in
    (* The first is 0 even where a = 1. *)
    let even = if m = 0. then 0. else m *. (b -. m) *. x /. (odd -. 1.) in
    m +. even +. ((a +. m) *. (off +. 1. +. (m *. (1. +. y))) /. (odd +. 1.))
  in
  let part m =
    let odd = a +. (2. *. m) -. 1. in
    (a +. m -. 1.)
    /. odd
    *. ((a +. b +. m -. 1.) /. odd)
    *. (m *. (b -. m) *. x *. x)
  in
  let rec go k rest =
    if k = 0 then rest
    else
      let m = float_of_int k in
      go (k - 1) (whole (m -. 1.) +. (part m /. rest))
  in
  go depth (whole (float_of_int depth))

(* Where x is below about the mean. *)
let beta_low a b odds =
  let y = 1. /. (1. +. odds) in
  let x = odds *. y and off = Float.fma (-.b) odds a *. y in
  let slope = beta_slope a b x y ~off in
  if slope = 0. then { lower = 0.; upper = 1.; slope }
  else
    let lower = slope /. settled (beta_fraction a b x y ~off) in
    { lower; upper = 1. -. lower; slope }

let beta a b ~odds =
  if not (valid a && valid b && odds >= 0.) then undefined
  else if odds *. (b +. 1.) <= a +. 1. then beta_low a b odds
  else
    let { lower; upper; slope } = beta_low b a (1. /. odds) in
    { lower = upper; upper = lower; slope }

(* Halfway in bits: halves the logarithm far from 1, and always ends. *)
let middle lo hi =
  let from = Int64.bits_of_float lo and upto = Int64.bits_of_float hi in
  Int64.(float_of_bits (add from (div (sub upto from) 2L)))

(* Newton's steps on the logarithm of the lesser tail by log x, which is concave,
   so that after the first they all come from one side; halves where one would
   leave what is known to hold the solution. *)
let inverse f ~start p =
  let low = p <= 0.5 in
  let rec go lo hi x =
    let { lower; upper; slope } = f x in
    let gap =
      if low then log (p /. lower) *. lower
      else log (upper /. (1. -. p)) *. upper
    in
    let next = x *. exp (gap /. slope) in
    let below = if low then lower < p else upper > 1. -. p in
    let lo = if below then x else lo and hi = if below then hi else x in
    if Float.is_nan slope then nan
    else if Float.equal next x then x
    else if lo < next && next < hi then go lo hi next
    else
      let half = middle lo hi in
      if lo < half && half < hi then go lo hi half else x
  in
  if not (p >= 0. && p <= 1. && start >= 0.) then nan
  else if p = 0. then 0.
  else if p = 1. then infinity
  else go 0. infinity start
