(** Exact arithmetic on the doubles as they are: rationals and their vectors. *)

open Candor_space

let q = Q.of_float
let ( + ) = Q.add
let ( - ) = Q.sub
let ( * ) = Q.mul
let ( / ) = Q.div
let zero = Q.zero
let one = Q.one
let two = Q.of_int 2

(** [power k] is 2^k. *)
let power k =
  if k >= 0 then Q.of_bigint (Z.shift_left Z.one k)
  else Q.make Z.one (Z.shift_left Z.one (-k))

type vec = { x : Q.t; y : Q.t; z : Q.t }

let v x y z = { x; y; z }
let point (p : Point.t) = v (q p.x) (q p.y) (q p.z)
let vec (a : Vec.t) = v (q a.x) (q a.y) (q a.z)
let add a b = v (a.x + b.x) (a.y + b.y) (a.z + b.z)
let sub a b = v (a.x - b.x) (a.y - b.y) (a.z - b.z)
let scale k a = v (k * a.x) (k * a.y) (k * a.z)
let dot a b = (a.x * b.x) + (a.y * b.y) + (a.z * b.z)

let cross a b =
  v
    ((a.y * b.z) - (a.z * b.y))
    ((a.z * b.x) - (a.x * b.z))
    ((a.x * b.y) - (a.y * b.x))

(** [size a] is the sum of the absolute components: at least the length of [a],
    at most √3 times it. *)
let size a = Q.abs a.x + Q.abs a.y + Q.abs a.z

(** [largest a] is at most the length of [a]. *)
let largest a = Q.max (Q.abs a.x) (Q.max (Q.abs a.y) (Q.abs a.z))

(** [along o d t] is [o + t·d]. *)
let along o d t = add o (scale t d)

(** [ulp x] is the distance from |x| to the next double. *)
let ulp x =
  let x = Float.abs x in
  Float.succ x -. x

(** [ulps_off x t] is how far the double [x] is from [t], in ulps of [t]. *)
let ulps_off x t = Q.to_float (Q.abs (q x - t) / q (ulp (Q.to_float t)))

(** [within k x t] is whether [x] is within [k] ulps of [t]. *)
let within k x t = Q.leq (Q.abs (q x - t)) (q k * q (ulp x))

(** [sqrt x] is the root of [x ≥ 0] to 260 bits. *)
let sqrt x =
  if Q.sign x = 0 then Q.zero
  else
    let nd = Z.mul (Q.num x) (Q.den x) in
    let k = Int.max 0 (Int.sub 260 (Int.div (Z.numbits nd) 2)) in
    Q.make (Z.sqrt (Z.shift_left nd (Int.mul 2 k))) (Z.shift_left (Q.den x) k)
