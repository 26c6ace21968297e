(** Numbers x·2^e with a double [x]: estimates, good to some 50 bits, that
    neither overflow nor underflow. *)

type t = { x : float; e : int }

let zero = { x = 0.; e = 0 }

let v x e =
  let x, k = Float.frexp x in
  { x; e = e + k }

let of_float x = v x 0

(** [of_dyadic a] is [a], rounded. *)
let of_dyadic a =
  let x, e = Dyadic.split a in
  { x; e }

let to_float a = Float.ldexp a.x a.e
let mul a b = v (a.x *. b.x) (a.e + b.e)
let div a b = v (a.x /. b.x) (a.e - b.e)
let abs a = { a with x = Float.abs a.x }
let neg a = { a with x = -.a.x }

let add a b =
  if a.x = 0. then b
  else if b.x = 0. then a
  else
    let e = Int.max a.e b.e in
    v (Float.ldexp a.x (a.e - e) +. Float.ldexp b.x (b.e - e)) e

let sub a b = add a (neg b)

let sqrt a =
  let odd = a.e land 1 in
  v (Float.sqrt (Float.ldexp a.x odd)) ((a.e - odd) / 2)

let leq a b = (sub a b).x <= 0.
let min a b = if leq a b then a else b
let max a b = if leq a b then b else a

(** [to_dyadic a] is [a], exactly. *)
let to_dyadic a = Dyadic.shift a.e (Dyadic.of_float a.x)
