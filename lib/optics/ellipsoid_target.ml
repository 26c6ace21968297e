open Candor_space
open Candor_sample

type t = {
  center : Point.t;
  both : bool;
  a : Vec.t; (* the images of the unit vectors *)
  b : Vec.t;
  c : Vec.t;
  inverse : Affine.t; (* to where it is the unit ball around 0 *)
  handed : float; (* the volume that [a], [b], [c] have at length 1 *)
}

type sample = { direction : Dir.t; density : float }

let full = 4. *. Float.pi
let unit a = (Dir.of_vec_or Dir.z a :> Vec.t)

(* By unit vectors, as products of three lengths might overflow. *)
let make m ~center ~(radii : Vec.t) ~both =
  let { Affine.x; y; z; _ } = Affine.columns m in
  let a = Vec.scale radii.x x
  and b = Vec.scale radii.y y
  and c = Vec.scale radii.z z in
  let a1 = unit a and b1 = unit b and c1 = unit c in
  let handed = Vec.dot (Vec.cross a1 b1) c1 in
  let row p q along =
    Vec.scale (1. /. handed /. Vec.norm along) (Vec.cross p q)
  in
  let x = row b1 c1 a and y = row c1 a1 b and z = row a1 b1 c in
  let inverse =
    {
      Affine.identity with
      xx = x.x;
      xy = x.y;
      xz = x.z;
      yx = y.x;
      yy = y.y;
      yz = y.z;
      zx = z.x;
      zy = z.y;
      zz = z.z;
    }
  in
  { center; both; a; b; c; inverse; handed = Float.abs handed }

(* {1 The axes of a form} *)

type form = {
  xx : float;
  yy : float;
  zz : float;
  xy : float;
  xz : float;
  yz : float;
}

type turned = { form : form; x : Vec.t; y : Vec.t; z : Vec.t }

(* A rotation that makes [xy] vanish (C. G. J. Jacobi, 1846); then y, z, x are
   called x, y, z. *)
let turn { form = m; x; y; z } =
  let k = if m.xy = 0. then 0. else (m.yy -. m.xx) /. (2. *. m.xy) in
  let t =
    if m.xy = 0. then 0.
    else Float.copy_sign 1. k /. (Float.abs k +. Float.hypot 1. k)
  in
  let cosine = 1. /. sqrt (1. +. (t *. t)) in
  let sine = t *. cosine in
  let form =
    {
      zz = m.xx -. (t *. m.xy);
      xx = m.yy +. (t *. m.xy);
      yy = m.zz;
      xz = 0.;
      yz = (cosine *. m.xz) -. (sine *. m.yz);
      xy = (sine *. m.xz) +. (cosine *. m.yz);
    }
  in
  {
    form;
    z = Vec.along (Vec.scale cosine x) y (-.sine);
    x = Vec.along (Vec.scale cosine y) x sine;
    y = z;
  }

(* Five rounds leave nothing beside the diagonal that doubles hold. *)
let rec turns n m = if n = 0 then m else turns (n - 1) (turn m)
let diagonal m = turns 15 m

type axis = { value : float; along : Vec.t }

let[@inline] falling p q = if p.value >= q.value then (p, q) else (q, p)

(* {1 The cone} *)

type cone = { frame : Frame.t; alpha : float; beta : float; gamma : float }

(* Lengths are in units of the distance of the centre, and the axes start from
   the way there: so nothing is lost from afar. *)
let form t ({ u; v; w } : Frame.t) distance =
  let row (n : Dir.t) =
    let n = (n :> Vec.t) in
    Vec.v
      (Vec.dot n t.a /. distance)
      (Vec.dot n t.b /. distance)
      (Vec.dot n t.c /. distance)
  in
  let x = row u and y = row v and z = row w in
  {
    xx = Vec.dot x x;
    yy = Vec.dot y y;
    zz = Vec.dot z z -. 1.;
    xy = Vec.dot x y;
    xz = Vec.dot x z;
    yz = Vec.dot y z;
  }

(* The smallest eigenvalue is what is left of larger numbers; their product
   holds all of its digits. *)
let cone t way ball_distance =
  let distance = Vec.norm way in
  let toward = Dir.of_vec_or Dir.z way in
  let frame = Frame.of_dir toward in
  let { form = m; x; y; z } =
    diagonal
      {
        form = form t frame distance;
        x = (frame.u :> Vec.t);
        y = (frame.v :> Vec.t);
        z = (frame.w :> Vec.t);
      }
  in
  let p, q = falling { value = m.xx; along = x } { value = m.yy; along = y } in
  let q, r = falling q { value = m.zz; along = z } in
  let p, q = falling p q in
  let dir v = Dir.of_vec_or toward v in
  let w = dir r.along in
  let w = if Dir.dot w toward < 0. then Dir.neg w else w in
  let product =
    Vec.norm t.c /. distance
    *. sqrt (ball_distance -. 1.)
    *. sqrt (ball_distance +. 1.)
    *. t.handed
    *. (Vec.norm t.a /. distance)
    *. (Vec.norm t.b /. distance)
  in
  let frame = { Frame.u = dir p.along; v = dir q.along; w } in
  let alpha = sqrt p.value in
  if q.value < -.r.value then
    let gamma = sqrt (-.r.value) in
    { frame; alpha; beta = product /. alpha /. gamma; gamma }
  else
    let beta = sqrt q.value in
    { frame; alpha; beta; gamma = product /. alpha /. beta }

(* {1 Choosing φ}

   For sin φ = sin τ · β/√(β² + γ²), x reaches ±αh/√(γ² + α²h²), h being cos τ,
   and dφ is βh/√(γ² + β²h²) dτ: τ is chosen by their product, taken in the
   middles of steps. *)

let steps = 16
let step = 0.5 *. Float.pi /. float_of_int steps

let squares =
  Float.Array.init steps (fun i ->
      let h = cos ((float_of_int i +. 0.5) *. step) in
      h *. h)

let[@inline] share { alpha; beta; gamma; _ } h2 =
  let g2 = gamma *. gamma in
  alpha *. beta *. h2
  /. (sqrt (g2 +. (alpha *. alpha *. h2)) *. sqrt (g2 +. (beta *. beta *. h2)))

let[@inline] stepped cone i = share cone (Float.Array.get squares i)

let sum cone =
  let rec add sum i =
    if i = steps then sum else add (sum +. stepped cone i) (i + 1)
  in
  add 0. 0

let cone_angle cone =
  let angle = 4. *. step *. sum cone in
  if angle > 0. && angle < infinity then angle else 0.

let[@inline] chosen cone i h2 =
  stepped cone i /. share cone h2 /. (4. *. step *. sum cone)

(* The step that [left] of the sum ends in, and the part of it. *)
let rec find cone i left =
  let part = stepped cone i in
  if i + 1 < steps && left >= part then find cone (i + 1) (left -. part)
  else (i, Float.min 1. (left /. part))

(* From [0;1[ to ]-1;1[. *)
let[@inline] centred u = (2. *. u) -. 1. +. 0x1p-53

let usable direction density =
  if density > 0. && density < infinity then Some { direction; density }
  else None

let sample_cone cone { Pattern.u; v } =
  let { alpha; beta; gamma; frame } = cone in
  let side = centred u in
  let i, part = find cone 0 (Float.abs side *. sum cone) in
  let tau = (float_of_int i +. part) *. step in
  let h = cos tau in
  let x = centred v *. alpha *. h /. Float.hypot gamma (alpha *. h)
  and y = Float.copy_sign (sin tau *. beta) side
  and z = Float.hypot gamma (h *. beta) in
  let k = sqrt ((1. -. x) *. (1. +. x)) /. Float.hypot y z in
  usable
    (Warp.to_world frame (Vec.v x (k *. y) (k *. z)))
    (chosen cone i (h *. h))

let cone_density cone d =
  let { alpha; beta; gamma; frame } = cone in
  let { Vec.x; y; z } = Warp.to_local frame d in
  let width = Float.hypot y z in
  let across = y *. gamma /. beta in
  let rest = (z -. across) *. (z +. across) in
  let x = x *. gamma /. alpha in
  if not (z > 0. && x *. x <= rest && rest > 0.) then 0.
  else
    let h = sqrt rest /. width in
    let sine = Float.abs y /. width *. (Float.hypot beta gamma /. beta) in
    let i = int_of_float (Float.atan2 sine h /. step) in
    let density = chosen cone (min i (steps - 1)) (h *. h) in
    if density > 0. && density < infinity then density else 0.

(* {1 All} *)

type seen = Nothing | Anywhere | Within of cone

(* The rounded surface counts as inside, if that emits. *)
let seen t from =
  let way = Point.sub t.center from in
  let distance = Vec.norm (Affine.vector t.inverse way) in
  if distance > 1. then Within (cone t way distance)
  else if t.both || distance > 1. -. 0x1p-40 then Anywhere
  else Nothing

let sample t ~from p =
  match seen t from with
  | Nothing -> None
  | Anywhere -> usable (Warp.sphere p) (1. /. full)
  | Within cone -> sample_cone cone p

let density t ~from d =
  match seen t from with
  | Nothing -> 0.
  | Anywhere -> 1. /. full
  | Within cone -> cone_density cone d

let solid_angle t ~from =
  match seen t from with
  | Nothing -> 0.
  | Anywhere -> full
  | Within cone -> cone_angle cone

let area { a; b; c; _ } =
  let x = Vec.norm (Vec.cross a b)
  and y = Vec.norm (Vec.cross b c)
  and z = Vec.norm (Vec.cross c a) in
  full *. Vec.norm (Vec.v x y z) /. sqrt 3.

let corners { center; a; b; c; _ } =
  let both f = [ f (-1.); f 1. ] in
  let at x y z =
    Point.add center (Vec.along (Vec.along (Vec.scale x a) b y) c z)
  in
  List.concat (both (fun x -> List.concat (both (fun y -> both (at x y)))))
