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

let verdict h (o : Point.t) (d : Vec.t) t =
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

let along h o d =
  let open Expansion in
  let n = Unrounded.vec (vec h) in
  let from = Unrounded.diff o (point h) in
  (sub (dot n from) (of_float h.c), dot n (Unrounded.vec d))

let normal h =
  let open Double_double in
  { x = of_float h.nx; y = of_float h.ny; z = of_float h.nz }

let depth h x =
  let from = Unrounded.pair_diff x (point h) in
  Double_double.(sub (of_float h.c) (dot (normal h) from))
