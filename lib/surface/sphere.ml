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

(* Of the roots near <= far of a t^2 + 2 h t + c, where q = -(h + sign(h) s): *)
let[@inline] choose a h c s cursor =
  if h < 0. then
    let q = s -. h in
    let near = c /. q in
    if near > 0. then Cursor.take cursor near outside
    else Cursor.take cursor (q /. a) inside
  else Cursor.take cursor (c /. -.(h +. s)) inside

let exact_offset (o : Point.t) s =
  {
    Double_double.x = Error_free.two_diff o.x s.x;
    y = Error_free.two_diff o.y s.y;
    z = Error_free.two_diff o.z s.z;
  }

(* The second tier: the same equation in double-double, for a direction that a
   power of two brought near 1. Distances come out in units of that direction. *)
let meet_carefully s o (d : Vec.t) cursor =
  let _, e = Float.frexp (Vec.largest d) in
  let part x = Double_double.of_float (Float.ldexp x (-e)) in
  let open Double_double in
  let d = { x = part d.x; y = part d.y; z = part d.z } in
  let f = exact_offset o s in
  let r2 = Error_free.two_product s.radius s.radius in
  let a = dot d d and h = dot f d in
  let closest = along f (-.(h.hi /. a.hi)) d in
  let rest = dot closest d in
  let g = add (sub r2 (dot closest closest)) (div (mul rest rest) a) in
  if not (g.hi >= 0.) then Contact.none
  else
    let root = sqrt (mul a g) in
    let c = sub (dot f f) r2 in
    let back t = Float.ldexp (to_float t) (-e) in
    if h.hi < 0. then
      let q = sub root h in
      let near = back (div c q) in
      if near > 0. then Cursor.take cursor near outside
      else Cursor.take cursor (back (div q a)) inside
    else Cursor.take cursor (back (div c (neg (add h root)))) inside

(* f.f - r^2 when the origin is close to the sphere, where the plain difference
   cancels: the errors of the squares, of their sums and of the offset itself
   are put back. *)
let power_of_point s (o : Point.t) fx fy fz r2 =
  let open Error_free in
  let x2 = fx *. fx and y2 = fy *. fy and z2 = fz *. fz in
  let s1 = x2 -. r2 in
  let s2 = s1 +. y2 in
  let s3 = s2 +. z2 in
  let sums =
    sum_error x2 (-.r2) s1 +. sum_error s1 y2 s2 +. sum_error s2 z2 s3
  in
  let products =
    product_error fx fx x2 +. product_error fy fy y2 +. product_error fz fz z2
    -. product_error s.radius s.radius r2
  in
  let offset =
    (fx *. sum_error o.x (-.s.x) fx)
    +. (fy *. sum_error o.y (-.s.y) fy)
    +. (fz *. sum_error o.z (-.s.z) fz)
  in
  s3 +. (sums +. products +. (2. *. offset))

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
  then meet_carefully s o d cursor
  else if p2 > r2 +. band then Contact.none
  else if not (p2 < 0.75 *. r2) then meet_carefully s o d cursor
  else
    let rest = (px *. dx) +. (py *. dy) +. (pz *. dz) in
    let g = r2 -. p2 +. (rest *. rest /. a) in
    let plain = f2 -. r2 in
    let c =
      if Float.abs plain > 0.75 *. f2 then plain
      else power_of_point s o fx fy fz r2
    in
    choose a h c (sqrt (a *. g)) cursor

(* With the origin on the sphere the equation is t (a t + 2 h) = 0. *)
let meet_again s (o : Point.t) (d : Vec.t) left cursor =
  match Contact.side left with
  | Outside -> Contact.none
  | Inside ->
      let h = Vec.dot (Point.sub o (center s)) d in
      Cursor.take cursor (-2. *. h /. Vec.dot d d) inside

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
