(** Vectors of {!Dyadic} numbers. *)

open Candor_space
open Dyadic

type t = { x : Dyadic.t; y : Dyadic.t; z : Dyadic.t }

let v x y z = { x; y; z }
let of_floats x y z = v (of_float x) (of_float y) (of_float z)
let point (p : Point.t) = of_floats p.x p.y p.z
let vec (a : Vec.t) = of_floats a.x a.y a.z
let add a b = v (a.x + b.x) (a.y + b.y) (a.z + b.z)
let sub a b = v (a.x - b.x) (a.y - b.y) (a.z - b.z)
let neg a = v (neg a.x) (neg a.y) (neg a.z)
let scale k a = if k == one then a else v (k * a.x) (k * a.y) (k * a.z)
let dot a b = (a.x * b.x) + (a.y * b.y) + (a.z * b.z)

let cross a b =
  v
    ((a.y * b.z) - (a.z * b.y))
    ((a.z * b.x) - (a.x * b.z))
    ((a.x * b.y) - (a.y * b.x))

(** [size a] is the sum of the absolute components: at least the length of [a].
*)
let size a = abs a.x + abs a.y + abs a.z

(** [largest a] is at most the length of [a]. *)
let largest a = max (abs a.x) (max (abs a.y) (abs a.z))
