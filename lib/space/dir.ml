type t = Vec.t [@@deriving show, eq, ord]

let[@inline] over (a : Vec.t) n = Vec.v (a.x /. n) (a.y /. n) (a.z /. n)

let[@inline never] of_extreme (a : Vec.t) =
  let m = Vec.largest a in
  if m = 0. || not (Vec.is_finite a) then None
  else
    (* A power of two brings the vector near 1 without changing its bits. *)
    let a =
      if m > 0x1p-400 && m < 0x1p400 then a else Vec.ldexp (-Vec.exponent a) a
    in
    Some (over a (sqrt (Vec.dot a a)))

let of_vec a =
  let d = Vec.dot a a in
  if Vec.has_plain_square d then Some (over a (sqrt d)) else of_extreme a

let of_vec_or default a =
  let d = Vec.dot a a in
  if Vec.has_plain_square d then over a (sqrt d)
  else match of_extreme a with Some u -> u | None -> default

let x = Vec.v 1. 0. 0.
let y = Vec.v 0. 1. 0.
let z = Vec.v 0. 0. 1.
let neg = Vec.neg
let dot = Vec.dot
