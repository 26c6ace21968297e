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

(* Of the roots near <= far of a t^2 + 2 h t + c, with s the root of h^2 - ac;
   [back] takes them to units of the ray's own direction. *)
let[@inline] choose a h c s ~back cursor =
  if h < 0. then
    let q = s -. h in
    let near = c /. q *. back in
    if near > 0. then Cursor.take cursor near outside
    else Cursor.take cursor (q /. a *. back) inside
  else Cursor.take cursor (c /. -.(h +. s) *. back) inside

(* The second tier. Every number that cancels is carried as a sum hi + lo of two
   doubles, after T. Ogita, S. M. Rump, S. Oishi, Accurate Sum and Dot Product,
   SIAM J. Sci. Comput. 26, 2005; written out, since nothing here may allocate.
   The direction has been brought near 1. *)
let meet_carefully s (o : Point.t) (d : Vec.t) ~back cursor =
  let open Error_free in
  let dx = d.x and dy = d.y and dz = d.z in
  let fx = o.x -. s.x and fy = o.y -. s.y and fz = o.z -. s.z in
  let lx = sum_error o.x (-.s.x) fx
  and ly = sum_error o.y (-.s.y) fy
  and lz = sum_error o.z (-.s.z) fz in
  let a = (dx *. dx) +. (dy *. dy) +. (dz *. dz) in
  (* h = f.d *)
  let hx = fx *. dx and hy = fy *. dy and hz = fz *. dz in
  let h2 = hx +. hy in
  let h3 = h2 +. hz in
  let h =
    h3
    +. (sum_error hx hy h2 +. sum_error h2 hz h3 +. product_error fx dx hx
      +. product_error fy dy hy +. product_error fz dz hz
       +. ((lx *. dx) +. (ly *. dy) +. (lz *. dz)))
  in
  (* p = f + t d, near the point of the line closest to the centre *)
  let t = -.h /. a in
  let tx = t *. dx and ty = t *. dy and tz = t *. dz in
  let sx = fx +. tx and sy = fy +. ty and sz = fz +. tz in
  let ex = sum_error fx tx sx +. product_error t dx tx +. lx
  and ey = sum_error fy ty sy +. product_error t dy ty +. ly
  and ez = sum_error fz tz sz +. product_error t dz tz +. lz in
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
    (* c = f.f - r^2 *)
    let x2 = fx *. fx and y2 = fy *. fy and z2 = fz *. fz in
    let c1 = x2 -. r2 in
    let c2 = c1 +. y2 in
    let c3 = c2 +. z2 in
    let c =
      c3
      +. (sum_error x2 (-.r2) c1 +. sum_error c1 y2 c2 +. sum_error c2 z2 c3
        +. product_error fx fx x2 +. product_error fy fy y2
        +. product_error fz fz z2 -. r2_lo
         +. (2. *. ((fx *. lx) +. (fy *. ly) +. (fz *. lz))))
    in
    choose a h c (sqrt (a *. g)) ~back cursor

(* For what the first tier cannot do: the direction is scaled to about 1 by a
   power of two. *)
let meet_scaled s o (d : Vec.t) cursor =
  let _, e = Float.frexp (Vec.largest d) in
  let part x = Float.ldexp x (-e) in
  let unit = Vec.v (part d.x) (part d.y) (part d.z) in
  meet_carefully s o unit ~back:(Float.ldexp 1. (-e)) cursor

let meet_freely s (o : Point.t) (d : Vec.t) cursor =
  let fx = o.x -. s.x and fy = o.y -. s.y and fz = o.z -. s.z in
  let dx = d.x and dy = d.y and dz = d.z in
  let a = (dx *. dx) +. (dy *. dy) +. (dz *. dz) in
  let h = (fx *. dx) +. (fy *. dy) +. (fz *. dz) in
  let t = -.h /. a in
  (* By the fused product, p is on the ray at t up to one rounding. *)
  let px = Float.fma t dx fx
  and py = Float.fma t dy fy
  and pz = Float.fma t dz fz in
  let p2 = (px *. px) +. (py *. py) +. (pz *. pz) in
  let r2 = s.radius *. s.radius in
  let f2 = (fx *. fx) +. (fy *. fy) +. (fz *. fz) in
  let band = (0x1p-49 *. (r2 +. (s.radius *. sqrt f2))) +. (0x1p-98 *. f2) in
  if
    not
      (a > 0x1p-500 && a < 0x1p500 && r2 > 0x1p-900 && r2 < 0x1p500
     && f2 < 0x1p500
      && f2 < 0x1p60 *. r2)
  then meet_scaled s o d cursor
  else if p2 > r2 +. band then Contact.none
  else
    let plain = f2 -. r2 in
    (* Near its edge, or from close by, the sphere is met with care. *)
    if p2 < 0.75 *. r2 && Float.abs plain > 0.5 *. f2 then
      let rest = (px *. dx) +. (py *. dy) +. (pz *. dz) in
      let g = r2 -. p2 +. (rest *. rest /. a) in
      choose a h plain (sqrt (a *. g)) ~back:1. cursor
    else meet_carefully s o d ~back:1. cursor

(* With the origin on the sphere the equation is t (a t + 2 h) = 0. *)
let meet_again s (o : Point.t) (d : Vec.t) left cursor =
  match Contact.side left with
  | Outside -> Contact.none
  | Inside ->
      let d, e = Unrounded.pair_near_one d in
      let f = Unrounded.pair_diff o (center s) in
      let open Double_double in
      let t = div (scale (-2.) (dot f d)) (dot d d) in
      Cursor.take cursor (Float.ldexp (to_float t) (-e)) inside

let meet s o d left cursor =
  if Contact.is_none left then meet_freely s o d cursor
  else meet_again s o d left cursor

let uv (n : Vec.t) =
  let y = Float.max (-1.) (Float.min 1. n.y) in
  ( 0.5 +. (Float.atan2 n.x n.z /. (2. *. Float.pi)),
    0.5 +. (Float.asin y /. Float.pi) )

let locate s o d t =
  let c = center s in
  let offset = Point.sub (Point.along o d t) c in
  let normal = Dir.of_vec_or Dir.x offset in
  let n = (normal :> Vec.t) in
  let point = Point.along c n s.radius in
  let error n p =
    (5. *. 0x1p-53 *. Float.abs (s.radius *. n)) +. (0x1p-53 *. Float.abs p)
  in
  {
    Local.point;
    normal;
    error = Vec.v (error n.x point.x) (error n.y point.y) (error n.z point.z);
    flat = false;
    uv = lazy (Some (uv n));
    shading_normal = None;
  }
