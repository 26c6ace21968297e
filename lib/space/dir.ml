type t = Vec.t [@@deriving show, eq, ord]

let of_vec (a : Vec.t) =
  let m = Vec.largest a in
  if m = 0. || not (Vec.is_finite a) then None
  else
    (* A power of two brings the vector near 1 without changing its bits. *)
    let a =
      if m > 0x1p-400 && m < 0x1p400 then a else Vec.ldexp (-Vec.exponent a) a
    in
    let n = sqrt (Vec.dot a a) in
    Some (Vec.v (a.x /. n) (a.y /. n) (a.z /. n))

let of_vec_or d a = match of_vec a with Some u -> u | None -> d
let x = Vec.v 1. 0. 0.
let y = Vec.v 0. 1. 0.
let z = Vec.v 0. 0. 1.
let neg = Vec.neg
let dot = Vec.dot
