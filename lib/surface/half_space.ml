open Candor_number
open Candor_space

type t = {
  nx : float;
  ny : float;
  nz : float;
  px : float;
  py : float;
  pz : float;
  c : float;
}
[@@deriving show, eq, ord]

let axis nx ny nz c = { nx; ny; nz; px = 0.; py = 0.; pz = 0.; c }

let of_bounds (b : Bounds.t) =
  List.filter
    (fun h -> Float.is_finite h.c)
    [
      axis (-1.) 0. 0. (-.b.x0);
      axis 1. 0. 0. b.x1;
      axis 0. (-1.) 0. (-.b.y0);
      axis 0. 1. 0. b.y1;
      axis 0. 0. (-1.) (-.b.z0);
      axis 0. 0. 1. b.z1;
    ]

type verdict = In | Out | Unsure

let verdict h (ray : Object_ray.t) t =
  let o = ray.origin and d = ray.direction in
  let part n p o d = n *. (o -. p +. (t *. d)) in
  let size n p o d =
    Float.abs n *. (Float.abs o +. Float.abs p +. Float.abs (t *. d))
  in
  let x = part h.nx h.px o.x d.x
  and y = part h.ny h.py o.y d.y
  and z = part h.nz h.pz o.z d.z in
  let sizes =
    size h.nx h.px o.x d.x +. size h.ny h.py o.y d.y +. size h.nz h.pz o.z d.z
  in
  let v = x +. y +. z -. h.c in
  let doubt = 0x1p-44 *. (sizes +. Float.abs h.c) in
  if v < -.doubt then In else if v > doubt then Out else Unsure

let vec h = Vec.v h.nx h.ny h.nz
let point h = Point.v h.px h.py h.pz

let along h ray =
  let open Expansion in
  let n = Unrounded.vec (vec h) in
  let from = Object_ray.from ray (point h) in
  (sub (dot n from) (of_float h.c), dot n (Object_ray.toward ray))

(* As if in twice the precision. *)
let speed h (ray : Object_ray.t) =
  let open Error_free in
  let d = ray.direction and d' = ray.direction_low in
  let v = dot h.nx h.ny h.nz d.x d.y d.z in
  v
  +. (dot_error h.nx h.ny h.nz d.x d.y d.z v
     +. dot h.nx h.ny h.nz d'.x d'.y d'.z)

let depth h (ray : Object_ray.t) =
  let open Error_free in
  let o = ray.origin and o' = ray.origin_low in
  let x = o.x -. h.px and y = o.y -. h.py and z = o.z -. h.pz in
  let x' = sum_error o.x (-.h.px) x +. o'.x
  and y' = sum_error o.y (-.h.py) y +. o'.y
  and z' = sum_error o.z (-.h.pz) z +. o'.z in
  let v = dot h.nx h.ny h.nz x y z in
  let w = h.c -. v in
  w
  +. (sum_error h.c (-.v) w
     -. (dot_error h.nx h.ny h.nz x y z v +. dot h.nx h.ny h.nz x' y' z'))
