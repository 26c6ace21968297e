open Candor_space
module A = Float.Array

type t = floatarray

let create n = A.create (6 * n)

let set b i (x : Bounds.t) =
  A.set b (6 * i) x.x0;
  A.set b ((6 * i) + 1) x.x1;
  A.set b ((6 * i) + 2) x.y0;
  A.set b ((6 * i) + 3) x.y1;
  A.set b ((6 * i) + 4) x.z0;
  A.set b ((6 * i) + 5) x.z1

let get b i : Bounds.t =
  let at k = A.get b ((6 * i) + k) in
  { x0 = at 0; x1 = at 1; y0 = at 2; y1 = at 3; z0 = at 4; z1 = at 5 }

let clear b i = set b i Bounds.empty
let copy b i c j = A.blit c (6 * j) b (6 * i) 6
let[@inline] lower b i x = if x < A.get b i then A.set b i x
let[@inline] raise_ b i x = if x > A.get b i then A.set b i x

let grow b i c j =
  for axis = 0 to 2 do
    lower b ((6 * i) + (2 * axis)) (A.get c ((6 * j) + (2 * axis)));
    raise_ b ((6 * i) + (2 * axis) + 1) (A.get c ((6 * j) + (2 * axis) + 1))
  done

let[@inline] low b i axis = A.get b ((6 * i) + (2 * axis))
let[@inline] high b i axis = A.get b ((6 * i) + (2 * axis) + 1)

(* Half of each, so that the sum cannot overflow. *)
let[@inline] center b i axis = (0.5 *. low b i axis) +. (0.5 *. high b i axis)

let grow_by_center b i c j =
  for axis = 0 to 2 do
    let x = center c j axis in
    lower b ((6 * i) + (2 * axis)) x;
    raise_ b ((6 * i) + (2 * axis) + 1) x
  done

let[@inline] extent b i axis = high b i axis -. low b i axis

let widest b i =
  let x = extent b i 0 and y = extent b i 1 and z = extent b i 2 in
  if x >= y && x >= z then 0 else if y >= z then 1 else 2

let half_area b i ~unit =
  if low b i 0 > high b i 0 then 0.
  else
    let x = extent b i 0 /. unit
    and y = extent b i 1 /. unit
    and z = extent b i 2 /. unit in
    (x *. y) +. (y *. z) +. (z *. x)
