open Candor_space

let pi = Float.pi

let to_world (f : Frame.t) (d : Vec.t) =
  let u = (f.u :> Vec.t) and v = (f.v :> Vec.t) and w = (f.w :> Vec.t) in
  Dir.of_vec_or f.w
    (Vec.v
       ((d.x *. u.x) +. (d.y *. v.x) +. (d.z *. w.x))
       ((d.x *. u.y) +. (d.y *. v.y) +. (d.z *. w.y))
       ((d.x *. u.z) +. (d.y *. v.z) +. (d.z *. w.z)))

let to_local (f : Frame.t) d =
  Vec.v (Dir.dot f.u d) (Dir.dot f.v d) (Dir.dot f.w d)

let unit_or_z x y z = Dir.of_vec_or Dir.z (Vec.v x y z)

(* From [0;1[ to ]-1;1[, the middles of steps of 2^-52: multiples of 2^-53 lose
   nothing, and no point is on the rim. *)
let[@inline] centred u = (2. *. u) -. 1. +. 0x1p-53

(* The radius may be negative. *)
type polar = { radius : float; angle : float }

let[@inline] concentric { Pattern.u; v } =
  let a = centred u and b = centred v in
  if Float.abs a > Float.abs b then
    { radius = a; angle = 0.25 *. pi *. (b /. a) }
  else if b = 0. then { radius = 0.; angle = 0. }
  else { radius = b; angle = (0.5 *. pi) -. (0.25 *. pi *. (a /. b)) }

let disk p =
  let { radius; angle } = concentric p in
  Vec.v (radius *. cos angle) (radius *. sin angle) 0.

let cosine_hemisphere p =
  let { radius = r; angle } = concentric p in
  let z = sqrt ((1. -. r) *. (1. +. r)) in
  unit_or_z (r *. cos angle) (r *. sin angle) z

let[@inline] cosine_hemisphere_density z = if z > 0. then z /. pi else 0.

(* 1 - cos is r^2 of that of the cone; the sine is its root times that of what
   is missing to 2. *)
let cone ~one_minus_cos p =
  let { radius = r; angle } = concentric p in
  let h = r *. r *. one_minus_cos in
  let k = r *. sqrt (one_minus_cos *. (2. -. h)) in
  unit_or_z (k *. cos angle) (k *. sin angle) (1. -. h)

let[@inline] cone_density ~one_minus_cos = 1. /. (2. *. pi *. one_minus_cos)
let sphere p = cone ~one_minus_cos:2. p

let[@inline] one_minus_cos ~sin2 =
  sin2 /. (1. +. sqrt (Float.max 0. (1. -. sin2)))

let[@inline] cone_of_ball ~distance ~radius =
  let sine = radius /. distance in
  let cosine =
    sqrt ((distance -. radius) /. distance *. ((distance +. radius) /. distance))
  in
  sine *. sine /. (1. +. cosine)

(* 1 + g^2 - 2g cos is (1 - |g|)^2 + 2|g| (1 - cos), with the angle from -w if g
   is negative; and 1 - cos is half the squared distance of the directions. *)
let henyey_greenstein ~g w w' =
  let w = (w : Dir.t :> Vec.t) and w' = (w' : Dir.t :> Vec.t) in
  let s = Float.copy_sign 1. g and g = Float.abs g in
  let x = w'.x -. (s *. w.x)
  and y = w'.y -. (s *. w.y)
  and z = w'.z -. (s *. w.z) in
  let d =
    ((1. -. g) *. (1. -. g)) +. (g *. ((x *. x) +. (y *. y) +. (z *. z)))
  in
  (1. -. g) *. (1. +. g) /. (4. *. pi *. d *. sqrt d)

(* For g >= 0 and k = 1 - g + 2gu, the inverse of the distribution function is
   1 - cos = 2 (1 - g)^2 (1 - u) (1 + gu) / k^2, and
   1 + cos = 2 (1 + g)^2 u (1 - g + gu) / k^2: all its terms are positive. *)
let henyey_greenstein_sample ~g { Pattern.u; v } =
  let s = Float.copy_sign 1. g and g = Float.abs g in
  let k = 1. -. g +. (2. *. g *. u) in
  let back = (1. -. g) /. k and forth = (1. +. g) /. k in
  let fall = 2. *. back *. back *. (1. -. u) *. (1. +. (g *. u))
  and rise = 2. *. forth *. forth *. u *. (1. -. g +. (g *. u)) in
  let sine = sqrt (fall *. rise) and angle = 2. *. pi *. v in
  unit_or_z (sine *. cos angle) (sine *. sin angle) (0.5 *. s *. (rise -. fall))

let[@inline] exponential ~rate u = -.Float.log1p (-.u) /. rate
let[@inline] exponential_density ~rate t = rate *. exp (-.(rate *. t))
