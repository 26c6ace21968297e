open Candor_number
open Candor_space

type t = Bounds.t [@@deriving show, eq, ord]

let make ~(min : Point.t) ~(max : Point.t) =
  let flat =
    List.length
      (List.filter Fun.id [ min.x = max.x; min.y = max.y; min.z = max.z ])
  in
  if not (Reach.point min && Reach.point max) then Error Reach.message
  else if min.x > max.x then Error "min is above max on the x axis"
  else if min.y > max.y then Error "min is above max on the y axis"
  else if min.z > max.z then Error "min is above max on the z axis"
  else if flat >= 2 then
    Error "min and max are equal on two axes: no face is left"
  else Ok (Bounds.v min max)

let bounds b = b

(* Where o + o' + t (d + d') reaches p, for d other than zero. Division, not the
   product with a reciprocal: it rounds once, and is right for subnormal
   directions. The low parts, if any, are made up for by one step of the
   division's remainder. *)
let[@inline] reach p o o' d d' =
  let n = p -. o in
  let t = n /. d in
  if (o' = 0. && d' = 0.) || not (Float.is_finite t) then t
  else
    let rest = Error_free.sum_error p (-.o) n -. o' -. (t *. d') in
    t +. ((Float.fma (-.t) d n +. rest) /. d)

(* A ray along a slab is in it for ever or never. *)
let[@inline] within lo hi o o' = lo -. o <= o' && o' <= hi -. o

let[@inline] enter lo hi o o' d d' =
  if d > 0. then reach lo o o' d d'
  else if d < 0. then reach hi o o' d d'
  else if within lo hi o o' then neg_infinity
  else infinity

let[@inline] leave lo hi o o' d d' =
  if d > 0. then reach hi o o' d d'
  else if d < 0. then reach lo o o' d d'
  else if within lo hi o o' then infinity
  else neg_infinity

let ends (b : Bounds.t) axis =
  if axis = 0 then (b.x0, b.x1)
  else if axis = 1 then (b.y0, b.y1)
  else (b.z0, b.z1)

(* Whether x <= y 2^e. Only what is of the same size is compared in full, and
   the smaller one is shifted up, so that nothing leaves the range. *)
let not_above x y e =
  let sx = Expansion.sign x and sy = Expansion.sign y in
  if sx <> sy || sx = 0 then sx <= sy
  else
    let size x = snd (Float.frexp (Expansion.to_float x)) in
    let more = size x - (size y + e) in
    if more > 1 then sx < 0
    else if more < -1 then sx > 0
    else
      let x = if e < 0 then Expansion.shift (-e) x else x
      and y = if e > 0 then Expansion.shift e y else y in
      Expansion.sign (Expansion.sub x y) <= 0

(* Whether the ray enters slab [i] no later than it leaves slab [j], exactly:
   (p - o_i) / d_i <= (q - o_j) / d_j, multiplied out. *)
let in_order b (ray : Object_ray.t) i j =
  let d = ray.direction in
  let di = Vec.get d i and dj = Vec.get d j in
  if di = 0. || dj = 0. then true
  else
    let low_i, high_i = ends b i and low_j, high_j = ends b j in
    let p = if di > 0. then low_i else high_i in
    let q = if dj > 0. then high_j else low_j in
    (* Lengths are brought near 2^600, so that no bit of a product is lost. *)
    let size x = snd (Float.frexp x) in
    let most = Float.max (Float.abs p) (Float.abs q) in
    let most = Float.max most (Float.abs (Point.get ray.origin i)) in
    let most = Float.max most (Float.abs (Point.get ray.origin j)) in
    let length x = Float.ldexp x (600 - size most) in
    let far p i =
      let open Expansion in
      sub
        (diff (length p) (length (Point.get ray.origin i)))
        (of_float (length (Vec.get ray.origin_low i)))
    in
    let speed d i =
      let unit x = Expansion.of_float (Float.ldexp x (-size d)) in
      let s = Expansion.add (unit d) (unit (Vec.get ray.direction_low i)) in
      if d > 0. then s else Expansion.neg s
    in
    let near = Expansion.mul (far p i) (speed dj j)
    and far = Expansion.mul (far q j) (speed di i) in
    let near = if di > 0. then near else Expansion.neg near
    and far = if dj > 0. then far else Expansion.neg far in
    not_above near far (size di - size dj)

(* [near] and [far] are where the ray enters slab [i] and leaves slab [j], and
   near <= far + slack. *)
let[@inline] ordered b ray i j ~near ~far ~slack =
  near < far -. slack || in_order b ray i j

let[@inline] entered axis (d : Vec.t) =
  Contact.v ~part:((2 * axis) + if Vec.get d axis > 0. then 0 else 1) Outside

let[@inline] left_by axis (d : Vec.t) =
  Contact.v ~part:((2 * axis) + if Vec.get d axis > 0. then 1 else 0) Inside

(* The times of a ray that is a sum of doubles are off by 2^-105 of what its
   origin takes to come from zero. *)
let[@inline] blur o d = if d = 0. then 0. else Float.abs (o /. d)

(* A ray that leaves an edge inwards from one face and outwards from the other
   meets that other one with the first step it takes. *)
let at_once (b : Bounds.t) d =
  let extent = Vec.largest (Point.sub (Bounds.high b) (Bounds.low b)) in
  0x1p-60 *. extent /. Vec.largest d

let meet_freely (b : Bounds.t) (ray : Object_ray.t) ~inside cursor =
  let o = ray.origin and d = ray.direction in
  let o' = ray.origin_low and d' = ray.direction_low in
  let nx = enter b.x0 b.x1 o.x o'.x d.x d'.x
  and fx = leave b.x0 b.x1 o.x o'.x d.x d'.x in
  let ny = enter b.y0 b.y1 o.y o'.y d.y d'.y
  and fy = leave b.y0 b.y1 o.y o'.y d.y d'.y in
  let nz = enter b.z0 b.z1 o.z o'.z d.z d'.z
  and fz = leave b.z0 b.z1 o.z o'.z d.z d'.z in
  let near = if ny > nx then ny else nx in
  let near = if nz > near then nz else near in
  let far = if fy < fx then fy else fx in
  let far = if fz < far then fz else far in
  (* Each end is within 1.5 ulp, so only a near tie needs the exact test; below
     the normal numbers an ulp is 2^-1074. *)
  let slack = (0x1p-50 *. Float.abs near) +. 0x1p-1072 in
  let slack =
    if ray.exact then slack
    else slack +. (0x1p-100 *. (blur o.x d.x +. blur o.y d.y +. blur o.z d.z))
  in
  if not (near < infinity && near <= far +. slack) then Contact.none
  else if
    not
      (near < far -. slack
      || (Cursor.careful cursor;
          ordered b ray 0 1 ~near:nx ~far:fy ~slack)
         && ordered b ray 0 2 ~near:nx ~far:fz ~slack
         && ordered b ray 1 0 ~near:ny ~far:fx ~slack
         && ordered b ray 1 2 ~near:ny ~far:fz ~slack
         && ordered b ray 2 0 ~near:nz ~far:fx ~slack
         && ordered b ray 2 1 ~near:nz ~far:fy ~slack)
  then Contact.none
  else if inside && far <= 0. then
    let axis = if fx = far then 0 else if fy = far then 1 else 2 in
    Cursor.take cursor (at_once b d) (left_by axis d)
  else if near > 0. && not inside then
    let axis = if nx = near then 0 else if ny = near then 1 else 2 in
    Cursor.take cursor near (entered axis d)
  else
    let axis = if fx = far then 0 else if fy = far then 1 else 2 in
    Cursor.take cursor far (left_by axis d)

let meet b ray left cursor =
  if Contact.is_none left then meet_freely b ray ~inside:false cursor
  else
    match Contact.side left with
    | Outside -> Contact.none
    | Inside -> meet_freely b ray ~inside:true cursor

let locate (b : Bounds.t) (ray : Object_ray.t) t contact =
  let part = Contact.part contact in
  let axis = part / 2 and high = part land 1 = 1 in
  let low_end, high_end = ends b axis in
  let face = if high then high_end else low_end in
  (* In the plane of the face, and rounding must not carry it over an edge. *)
  let on i p =
    let lo, hi = ends b i in
    if i = axis then face else if p < lo then lo else if p > hi then hi else p
  in
  let { Point.x; y; z } = Point.along ray.origin ray.direction t in
  let point = Point.v (on 0 x) (on 1 y) (on 2 z) in
  let outward = if axis = 0 then Dir.x else if axis = 1 then Dir.y else Dir.z in
  let across i =
    let lo, hi = ends b i in
    if hi > lo then (Point.get point i -. lo) /. (hi -. lo) else 0.
  in
  let first = if axis = 0 then 1 else 0 in
  let second = if axis = 2 then 1 else 2 in
  {
    Local.point;
    normal = (if high then outward else Dir.neg outward);
    error = Vec.zero;
    flat = true;
    uv = lazy (Some (across first, across second));
    smooth = None;
  }
