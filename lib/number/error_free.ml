type t = { hi : float; lo : float }

let[@inline] sum_error a b s =
  let b' = s -. a in
  a -. (s -. b') +. (b -. b')

let[@inline] product_error a b p = Float.fma a b (-.p)

let[@inline] two_sum a b =
  let hi = a +. b in
  { hi; lo = sum_error a b hi }

let[@inline] two_diff a b = two_sum a (-.b)

let[@inline] two_product a b =
  let hi = a *. b in
  { hi; lo = product_error a b hi }

let[@inline] difference_of_products a b c d =
  let w = c *. d in
  let e = Float.fma (-.c) d w in
  let f = Float.fma a b (-.w) in
  f +. e

let[@inline] dot a b c x y z = (a *. x) +. (b *. y) +. (c *. z)

let[@inline] dot_error a b c x y z s =
  let p = a *. x and q = b *. y and r = c *. z in
  let pq = p +. q in
  sum_error p q pq +. sum_error pq r s +. product_error a x p
  +. product_error b y q +. product_error c z r
