open Candor_number
open Candor_space

type t = { x : float; y : float; z : float; radius : float }
[@@deriving show, eq, ord]

let center s = Point.v s.x s.y s.z

let make ~(center : Point.t) ~radius =
  if not (Reach.point center) then Error Reach.message
  else if not (radius > 0.) then Error "the radius must be above 0"
  else if radius < 0x1p-400 || radius > 0x1p400 then
    Error "the radius must be between 2^-400 and 2^400"
  else Ok { x = center.x; y = center.y; z = center.z; radius }

let bounds s =
  let r = Vec.v s.radius s.radius s.radius in
  let c = center s in
  Bounds.widen 0. (Bounds.v (Point.add c (Vec.neg r)) (Point.add c r))

let outside = Contact.v ~part:0 Outside
let inside = Contact.v ~part:0 Inside

(* d.d in twice the precision. *)
let squared (ray : Object_ray.t) =
  let open Error_free in
  let { Vec.x; y; z } = ray.direction and d' = ray.direction_low in
  let a = dot x y z x y z in
  a +. (dot_error x y z x y z a +. (2. *. dot x y z d'.x d'.y d'.z))

(* Of the roots near <= far of a t^2 + 2 h t + c, with s the root of h^2 - ac;
   [back] takes them to units of the ray's own direction. *)
let[@inline] choose ray h c s ~back cursor =
  if h < 0. then
    let q = s -. h in
    let near = c /. q *. back in
    if near > 0. then Cursor.take cursor near outside
    else Cursor.take cursor (q /. squared ray *. back) inside
  else Cursor.take cursor (c /. -.(h +. s) *. back) inside

(* The power f.f - r^2 of a point at f + l from the centre, in twice the
   precision: near the sphere it is lost in the rounding of the squares. *)
let[@inline] power r fx fy fz lx ly lz =
  let open Error_free in
  let r2 = r *. r in
  let x2 = fx *. fx and y2 = fy *. fy and z2 = fz *. fz in
  let c1 = x2 -. r2 in
  let c2 = c1 +. y2 in
  let c3 = c2 +. z2 in
  c3
  +. (sum_error x2 (-.r2) c1 +. sum_error c1 y2 c2 +. sum_error c2 z2 c3
    +. product_error fx fx x2 +. product_error fy fy y2
    +. product_error fz fz z2 -. product_error r r r2
     +. (2. *. dot fx fy fz lx ly lz))

(* The second tier. Every number that cancels is carried as a sum hi + lo of two
   doubles, after T. Ogita, S. M. Rump, S. Oishi, Accurate Sum and Dot Product,
   SIAM J. Sci. Comput. 26, 2005; written out, since nothing here may allocate.
   The direction has been brought near 1. *)
let meet_carefully s (ray : Object_ray.t) ~back cursor =
  let open Error_free in
  Cursor.careful cursor;
  let o = ray.origin and d = ray.direction in
  let o' = ray.origin_low and d' = ray.direction_low in
  let dx = d.x and dy = d.y and dz = d.z in
  let fx = o.x -. s.x and fy = o.y -. s.y and fz = o.z -. s.z in
  let lx = sum_error o.x (-.s.x) fx +. o'.x
  and ly = sum_error o.y (-.s.y) fy +. o'.y
  and lz = sum_error o.z (-.s.z) fz +. o'.z in
  let a = squared ray in
  (* h = f.d *)
  let h = dot fx fy fz dx dy dz in
  let h =
    h
    +. (dot_error fx fy fz dx dy dz h
       +. dot lx ly lz dx dy dz
       +. dot fx fy fz d'.x d'.y d'.z)
  in
  (* p = f + t d, near the point of the line closest to the centre *)
  let t = -.h /. a in
  let tx = t *. dx and ty = t *. dy and tz = t *. dz in
  let sx = fx +. tx and sy = fy +. ty and sz = fz +. tz in
  let ex = sum_error fx tx sx +. product_error t dx tx +. (lx +. (t *. d'.x))
  and ey = sum_error fy ty sy +. product_error t dy ty +. (ly +. (t *. d'.y))
  and ez = sum_error fz tz sz +. product_error t dz tz +. (lz +. (t *. d'.z)) in
  let px = sx +. ex and py = sy +. ey and pz = sz +. ez in
  let ex = ex -. (px -. sx)
  and ey = ey -. (py -. sy)
  and ez = ez -. (pz -. sz) in
  let rest =
    (px *. dx) +. (py *. dy) +. (pz *. dz)
    +. ((ex *. dx) +. (ey *. dy) +. (ez *. dz))
  in
  (* g = r^2 - p.p + (p.d)^2 / a *)
  let r2 = s.radius *. s.radius in
  let r2_lo = product_error s.radius s.radius r2 in
  let x2 = px *. px and y2 = py *. py and z2 = pz *. pz in
  let g1 = r2 -. x2 in
  let g2 = g1 -. y2 in
  let g3 = g2 -. z2 in
  let g =
    g3
    +. (sum_error r2 (-.x2) g1 +. sum_error g1 (-.y2) g2
      +. sum_error g2 (-.z2) g3 +. r2_lo
       -. (product_error px px x2 +. product_error py py y2
         +. product_error pz pz z2)
       -. (2. *. ((px *. ex) +. (py *. ey) +. (pz *. ez)))
       +. (rest *. rest /. a))
  in
  if not (g >= 0.) then Contact.none
  else
    let c = power s.radius fx fy fz lx ly lz in
    choose ray h c (sqrt (a *. g)) ~back cursor

(* For what the first tier cannot do: the direction is scaled to about 1 by a
   power of two. *)
let meet_scaled s ray cursor =
  let ray, e = Object_ray.near_one ray in
  meet_carefully s ray ~back:(Float.ldexp 1. (-e)) cursor

(* Whether the ray surely meets nothing up to t = [limit], by the signs of F =
   a t^2 + 2 h t + c at both ends. F is off by 2^-48 of [size] at the most, and a
   root less than 2^-48 beyond [limit] counts as before it. *)
let[@inline] beyond ~a ~h ~f2 ~r2 limit =
  let far = a *. limit in
  let size = f2 +. r2 and far2 = far *. limit in
  let c = f2 -. r2 in
  let f = far2 +. (2. *. h *. limit) +. c in
  let least = 0x1p-46 *. size in
  let enough = least +. (0x1p-46 *. far2) in
  if c > least then h >= 0. || (f > enough && far < (1. -. 0x1p-46) *. -.h)
  else c < -.least && f < -.enough

let meet_freely s (ray : Object_ray.t) (cursor : Cursor.t) =
  let o = ray.origin and d = ray.direction in
  let dx = d.x and dy = d.y and dz = d.z in
  let fx = o.x -. s.x and fy = o.y -. s.y and fz = o.z -. s.z in
  let a = (dx *. dx) +. (dy *. dy) +. (dz *. dz) in
  let h = (fx *. dx) +. (fy *. dy) +. (fz *. dz) in
  let r2 = s.radius *. s.radius in
  let f2 = (fx *. fx) +. (fy *. fy) +. (fz *. fz) in
  if
    not
      (a > 0x1p-400 && a < 0x1p400 && r2 > 0x1p-500 && r2 < 0x1p500
     && f2 < 0x1p500
      && f2 < 0x1p60 *. r2)
  then meet_scaled s ray cursor
  else if ray.exact && beyond ~a ~h ~f2 ~r2 cursor.t then Contact.none
  else
    let o' = ray.origin_low and d' = ray.direction_low in
    let t = -.h /. a in
    (* By the fused product, p is on the ray at t up to one rounding. *)
    let px = Float.fma t dx fx
    and py = Float.fma t dy fy
    and pz = Float.fma t dz fz in
    (* Low parts move p a little, and count for no more than roundings in the
       rest; unless the origin's are not small beside f. *)
    let px = px +. (o'.x +. (t *. d'.x))
    and py = py +. (o'.y +. (t *. d'.y))
    and pz = pz +. (o'.z +. (t *. d'.z)) in
    let p2 = (px *. px) +. (py *. py) +. (pz *. pz) in
    let lost = if ray.exact then 0. else Vec.largest o' in
    let off = (0x1p-49 *. (s.radius +. sqrt f2)) +. (0x1p-48 *. lost) in
    let band = (s.radius *. off) +. (off *. off) in
    if p2 > r2 +. band then Contact.none
    else
      (* From near the sphere more hangs on the root of the discriminant. *)
      let near = not (Float.abs (f2 -. r2) > 0.8 *. f2) in
      if
        (* Near its edge the sphere is met with care. *)
        p2 < (if near then 0.6 else 0.75) *. r2
        && lost *. lost <= 0x1p-106 *. f2
      then
        let rest = (px *. dx) +. (py *. dy) +. (pz *. dz) in
        let g = r2 -. p2 +. (rest *. rest /. a) in
        let open Error_free in
        let lx = sum_error o.x (-.s.x) fx +. o'.x
        and ly = sum_error o.y (-.s.y) fy +. o'.y
        and lz = sum_error o.z (-.s.z) fz +. o'.z in
        let low = dot lx ly lz dx dy dz +. dot fx fy fz d'.x d'.y d'.z in
        let h = Float.fma fx dx (Float.fma fy dy (Float.fma fz dz low)) in
        let c = power s.radius fx fy fz lx ly lz in
        choose ray h c (sqrt (a *. g)) ~back:1. cursor
      else meet_carefully s ray ~back:1. cursor

(* Whether the root -2h / a surely lies beyond [limit]. *)
let beyond_again s (ray : Object_ray.t) limit =
  let o = ray.origin and d = ray.direction in
  let fx = o.x -. s.x and fy = o.y -. s.y and fz = o.z -. s.z in
  let a = (d.x *. d.x) +. (d.y *. d.y) +. (d.z *. d.z) in
  let h = (fx *. d.x) +. (fy *. d.y) +. (fz *. d.z) in
  let f2 = (fx *. fx) +. (fy *. fy) +. (fz *. fz) in
  a > 0x1p-400 && a < 0x1p400 && f2 > 0x1p-400 && f2 < 0x1p500
  && (a *. limit) +. (0x1p-46 *. ((a *. limit) +. sqrt (a *. f2))) < -2. *. h

(* With the origin on the sphere the equation is t (a t + 2 h) = 0. *)
let meet_again s (ray : Object_ray.t) left (cursor : Cursor.t) =
  match Contact.side left with
  | Outside -> Contact.none
  | Inside when ray.exact && beyond_again s ray cursor.t -> Contact.none
  | Inside ->
      Cursor.careful cursor;
      let d, e = Object_ray.pair_near_one ray in
      let f = Object_ray.pair_from ray (center s) in
      let open Double_double in
      let t = div (scale (-2.) (dot f d)) (dot d d) in
      Cursor.take cursor (Float.ldexp (to_float t) (-e)) inside

let meet s ray left cursor =
  if Contact.is_none left then meet_freely s ray cursor
  else meet_again s ray left cursor

let uv (n : Vec.t) =
  let y = Float.max (-1.) (Float.min 1. n.y) in
  ( 0.5 +. (Float.atan2 n.x n.z /. (2. *. Float.pi)),
    0.5 +. (Float.asin y /. Float.pi) )

(* A point near the hit, as seen from the centre, for a ray from so far that t is
   not fine enough: by the way from the point of the ray nearest to the centre. *)
let from_closest s (ray : Object_ray.t) contact =
  let d = ray.direction in
  let p = Object_ray.closest ray (center s) in
  let left = (s.radius *. s.radius) -. Vec.dot p p in
  let half = sqrt (Float.max 0. left /. Vec.dot d d) in
  match Contact.side contact with
  | Outside -> Vec.along p d (-.half)
  | Inside -> Vec.along p d half

(* From this many times the radius. *)
let far = 0x1p10

let near_hit s (ray : Object_ray.t) t contact =
  let reach = t *. Vec.norm ray.direction in
  if reach > far *. s.radius then
    Point.add (center s) (from_closest s ray contact)
  else Point.along ray.origin ray.direction t

(* One Newton step takes the point to the sphere, up to its rounding and the
   square of the step. *)
let locate s ray t contact =
  let near = near_hit s ray t contact in
  let y = Point.sub near (center s) in
  let rest = Unrounded.diff_error near (center s) y in
  let off = power s.radius y.x y.y y.z rest.x rest.y rest.z in
  let k = -.off /. (2. *. s.radius *. s.radius) in
  let point = Point.along near y k in
  let normal = Dir.of_vec_or Dir.x y in
  let n = (normal :> Vec.t) in
  let error n p =
    (0x1p-52 *. Float.abs p) +. (Float.abs n *. (k *. k *. s.radius))
  in
  {
    Local.point;
    normal;
    error = Vec.v (error n.x point.x) (error n.y point.y) (error n.z point.z);
    flat = false;
    uv = lazy (Some (uv n));
    smooth = None;
  }
