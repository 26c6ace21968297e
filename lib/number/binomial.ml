let valid successes n = 0 <= successes && successes <= n && n <= 0x80_0000_0000

(* The probability of at least [k] of [n] is the lower tail of this at p/(1 - p),
   if k > 0; that of at most [k], if k < n, is the upper tail for k + 1. *)
let at_least k n odds =
  Incomplete.beta (float_of_int k) (float_of_int (n - k + 1)) ~odds

let test ~successes:k n p =
  if not (valid k n && p >= 0. && p <= 1.) then nan
  else
    let odds = p /. (1. -. p) in
    let above = if k = 0 then 1. else (at_least k n odds).lower in
    let below = if k = n then 1. else (at_least (k + 1) n odds).upper in
    Float.min 1. (2. *. Float.min above below)

(* The odds at which at least [k] of [n] have probability [p]. *)
let odds k n p =
  if k = 0 then 0.
  else
    let start = float_of_int k /. float_of_int (n - k + 1) in
    Incomplete.inverse (at_least k n) ~start p

let interval ~confidence ~successes:k n =
  if not (valid k n && confidence >= 0. && confidence <= 1.) then (nan, nan)
  else
    let tail = (1. -. confidence) /. 2. in
    let least = odds k n tail and most = odds (n - k) n tail in
    (least /. (1. +. least), 1. /. (1. +. most))
