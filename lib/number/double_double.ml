type t = Error_free.t = { hi : float; lo : float }

let of_float hi = { hi; lo = 0. }

(* For |a| >= |b| or a = 0. *)
let[@inline] renormalise a b =
  let hi = a +. b in
  { hi; lo = b -. (hi -. a) }

let add a b =
  let s = Error_free.two_sum a.hi b.hi and t = Error_free.two_sum a.lo b.lo in
  let v = renormalise s.hi (s.lo +. t.hi) in
  renormalise v.hi (t.lo +. v.lo)

let neg a = { hi = -.a.hi; lo = -.a.lo }
let sub a b = add a (neg b)

let mul a b =
  let p = Error_free.two_product a.hi b.hi in
  renormalise p.hi (p.lo +. Float.fma a.hi b.lo (a.lo *. b.hi))

let scale k a =
  let p = Error_free.two_product k a.hi in
  renormalise p.hi (Float.fma k a.lo p.lo)

let div a b =
  let q = a.hi /. b.hi in
  if not (Float.is_finite q) then of_float q
  else
    let rest = sub a (scale q b) in
    let r = rest.hi /. b.hi in
    let rest = sub rest (scale r b) in
    add (renormalise q r) (of_float (rest.hi /. b.hi))

let to_float a = a.hi +. a.lo

type vec = { x : t; y : t; z : t }

let dot a b = add (mul a.x b.x) (add (mul a.y b.y) (mul a.z b.z))
