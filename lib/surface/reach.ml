open Candor_space

let length x = Float.abs x <= 0x1p400
let point (p : Point.t) = length p.x && length p.y && length p.z
let vec (a : Vec.t) = length a.x && length a.y && length a.z
let message = "coordinates must be finite and at most 2^400 in size"
