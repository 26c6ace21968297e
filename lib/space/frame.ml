type t = { u : Dir.t; v : Dir.t; w : Dir.t }

let of_dir (w : Dir.t) =
  let { Vec.x; y; z } = (w :> Vec.t) in
  let sign = Float.copy_sign 1. z in
  let a = -1. /. (sign +. z) in
  let b = x *. y *. a in
  let u = Vec.v (1. +. (sign *. x *. x *. a)) (sign *. b) (-.sign *. x) in
  let v = Vec.v b (sign +. (y *. y *. a)) (-.y) in
  { u = Dir.of_vec_or Dir.x u; v = Dir.of_vec_or Dir.y v; w }
