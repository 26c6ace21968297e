(* u (1 + 2u) with u = 2^-53: times |x|, it is above half the way to the next
   double and below the middle between that and the one after it. *)
let more_than_half = 0x1.0000000000001p-53

let[@inline] step x =
  let size = Float.abs x in
  if size > 0x1p-900 && size < 0x1p1000 then more_than_half *. size else nan

let[@inline] succ x =
  let e = step x in
  if e > 0. then x +. e else Float.succ x

let[@inline] pred x =
  let e = step x in
  if e > 0. then x -. e else Float.pred x
