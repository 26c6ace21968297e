type t = { hi : float; lo : float }

let[@inline] sum_error a b s =
  let b' = s -. a in
  a -. (s -. b') +. (b -. b')

let[@inline] product_error a b p = Float.fma a b (-.p)

let[@inline] is_mild x =
  let a = Float.abs x in
  (a > 0x1p-480 && a < 0x1p480) || a = 0.

let[@inline] head x =
  let y = 0x1.0000002p27 *. x in
  y -. (y -. x)

let[@inline] mild_product_error a ah b bh p =
  let al = a -. ah and bl = b -. bh in
  (ah *. bh) -. p +. (ah *. bl) +. (al *. bh) +. (al *. bl)

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

let[@inline] mild_dot_error a a1 b b1 c c1 x x1 y y1 z z1 s =
  let p = a *. x and q = b *. y and r = c *. z in
  let pq = p +. q in
  sum_error p q pq +. sum_error pq r s
  +. mild_product_error a a1 x x1 p
  +. mild_product_error b b1 y y1 q
  +. mild_product_error c c1 z z1 r
