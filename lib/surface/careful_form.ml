open Candor_number
open Candor_space
open Piece

(* y + y' + t (d + d') *)
let further (y : Vec.t) (y' : Vec.t) t (d : Vec.t) (d' : Vec.t) =
  let open Error_free in
  let part y y' d d' =
    let m = t *. d in
    let s = y +. m in
    two_sum s (sum_error y m s +. product_error t d m +. (y' +. (t *. d')))
  in
  let x = part y.x y'.x d.x d'.x
  and y = part y.y y'.y d.y d'.y
  and z = part y.z y'.z d.z d'.z in
  (Vec.v x.hi y.hi z.hi, Vec.v x.lo y.lo z.lo)

(* dAd, exactly, rounded to a sum of two doubles: along a generator it cancels
   to less than twice the precision leaves of it. *)
let exact_bend f ray =
  let zero = Expansion.of_float 0. in
  let a, _, _ =
    Form.along_exactly f
      { x = zero; y = zero; z = zero }
      (Object_ray.toward ray)
  in
  Expansion.to_pair a

let bend f (ray : Object_ray.t) =
  let d = ray.direction in
  let a = Form.bend f d ray.direction_low in
  if a.hi = 0. || Float.abs a.hi > 0x1p-45 *. f.Form.a_size *. Vec.dot d d then
    a
  else exact_bend f ray

(* F at the origin y + y'. On the surface, or all but, it is taken exactly. *)
let value q ray y y' =
  let f = q.form in
  let c = Form.value f y y' in
  let far = Vec.norm y in
  let size =
    (((f.a_size *. far) +. (2. *. f.g_size)) *. far) +. Float.abs f.k
  in
  if Float.abs c.hi > 0x1p-45 *. size then c
  else
    let _, _, c = exact_equation q ray in
    Expansion.to_pair c

(* b^2 - a c, each a sum of two doubles. *)
let discriminant (a : Error_free.t) (b : Error_free.t) (c : Error_free.t) =
  Error_free.difference_of_products b.hi b.hi a.hi c.hi
  +. ((2. *. b.hi *. b.lo) -. ((a.hi *. c.lo) +. (a.lo *. c.hi)))

(* The discriminant is taken at the point of the line nearest to the centre; the
   direction is near 1 by a power of two, which is then taken out of t. *)
let meet q ray cursor =
  Cursor.careful cursor;
  let near, e = Object_ray.near_one ray in
  let back t = Float.ldexp t (-e) in
  let d = near.direction and d' = near.direction_low in
  let y, y' = Object_ray.offset near (Form.center q.form) in
  let a = bend q.form near in
  let b = Form.rise q.form y y' d d' and c = value q near y y' in
  if a.hi = 0. then
    if b.hi = 0. then Contact.none
    else consider q ray (back (-.c.hi /. (2. *. b.hi))) b.hi First cursor
  else
    let closest = -.Vec.dot y d /. Vec.dot d d in
    let p, p' = further y y' closest d d' in
    let disc =
      discriminant a (Form.rise q.form p p' d d') (Form.value q.form p p')
    in
    if not (disc >= 0.) then Contact.none
    else
      let root = sqrt disc in
      let r = if b.hi >= 0. then -.(b.hi +. root) else root -. b.hi in
      let first = if r = 0. then 0. else back (c.hi /. r) in
      let earlier = consider q ray first b.hi First cursor in
      later earlier (consider q ray (back (r /. a.hi)) b.hi Second cursor)

(* With the origin on the surface the equation is t (a t + 2 b) = 0. Leaving
   outwards F rises, so b > 0, and the other root is ahead only if a < 0. *)
let meet_again q ray side cursor =
  Cursor.careful cursor;
  let near, e = Object_ray.near_one ray in
  let back t = Float.ldexp t (-e) in
  let d = near.direction and d' = near.direction_low in
  let y, y' = Object_ray.offset near (Form.center q.form) in
  let a = (bend q.form near).hi and b = (Form.rise q.form y y' d d').hi in
  let ahead =
    match (side : Side.t) with
    | Outside -> b > 0. && a < 0.
    | Inside -> b < 0. && a > 0.
  in
  if not ahead then Contact.none
  else consider q ray (back (-2. *. (b /. a))) b Second cursor
