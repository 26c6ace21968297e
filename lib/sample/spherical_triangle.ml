open Candor_number
open Candor_space

(* Corners as directions. With them the tangent of half the solid angle is
   [volume] over [past] + [beside], and a smaller triangle a, b, x with x between
   a and c has for a + x the direction of
   (volume cos h - past sin h) a + (beside sin h) c, h being half its area. *)
type t = {
  a : Vec.t;
  b : Vec.t;
  c : Vec.t;
  volume : float;
  past : float;
  beside : float;
  half : float;
}

let exact (a : Vec.t) =
  let open Expansion in
  { x = of_float a.x; y = of_float a.y; z = of_float a.z }

(* a . (b x c), from the differences to [a], which keep the digits of a small
   triangle seen from afar; exactly where it is seen so obliquely, or is so thin,
   that the rounding of these differences tells. *)
let triple (a : Vec.t) b c =
  let e = Vec.sub b a and f = Vec.sub c a in
  let minor = Error_free.difference_of_products in
  let x = minor e.y f.z e.z f.y
  and y = minor e.z f.x e.x f.z
  and z = minor e.x f.y e.y f.x in
  let s = Error_free.dot a.x a.y a.z x y z in
  if Float.abs s > 0x1p-10 *. Vec.norm1 a *. Vec.norm1 e *. Vec.norm1 f then s
  else Expansion.(to_float (dot (exact a) (cross (exact b) (exact c))))

(* |a . (b x c)| over the three lengths. Errors are least from the shortest. *)
let[@inline] volume a b c la lb lc =
  let v =
    if la <= lb && la <= lc then triple a b c
    else if lb <= lc then triple b c a
    else triple c a b
  in
  if v = 0. then 0. else Float.abs v /. la /. lb /. lc

(* [l] is the length of [a]. Where it is near 1, directions are made by dividing
   by just that. *)
let[@inline] direction (a : Vec.t) l =
  if l > 0x1p-300 && l < 0x1p300 then Vec.v (a.x /. l) (a.y /. l) (a.z /. l)
  else (Dir.of_vec_or Dir.z a :> Vec.t)

let of_scaled a b c =
  let la = Vec.norm a and lb = Vec.norm b and lc = Vec.norm c in
  let volume = volume a b c la lb lc in
  let a = direction a la and b = direction b lb and c = direction c lc in
  let past = Vec.dot a c +. Vec.dot b c and beside = 1. +. Vec.dot a b in
  let half = if volume > 0. then Float.atan2 volume (past +. beside) else 0. in
  { a; b; c; volume; past; beside; half }

let make a b c =
  let sizes = Vec.v (Vec.largest a) (Vec.largest b) (Vec.largest c) in
  let m = Vec.largest sizes in
  if m > 0. && Float.is_finite m then
    let e = -Vec.exponent sizes in
    of_scaled (Vec.ldexp e a) (Vec.ldexp e b) (Vec.ldexp e c)
  else of_scaled Vec.zero Vec.zero Vec.zero

let solid_angle t = 2. *. t.half

let total triangles =
  List.fold_left (fun sum t -> sum +. solid_angle t) 0. triangles

let density t = if t.half > 0. then 0.5 /. t.half else 0.

let[@inline] squared_distance a b =
  let d = Vec.sub a b in
  Vec.dot d d

(* [a] turned by twice the angle between it and [r]. *)
let[@inline] reflected (a : Vec.t) r =
  Vec.sub (Vec.scale (2. *. Vec.dot a r /. Vec.dot r r) r) a

let cut t u =
  let h = u *. t.half in
  let sine = sin h in
  let at_a = (t.volume *. cos h) -. (t.past *. sine)
  and at_c = t.beside *. sine in
  let w = at_c /. (at_a +. at_c) in
  reflected t.a (Vec.along t.a (Vec.sub t.c t.a) w)

(* 1 - cos of the arc from [b] to [x] is k, from [b] to the result v k. *)
let sample t { Pattern.u; v } =
  let x = cut t u in
  let k = 0.5 *. squared_distance x t.b in
  let at_x = sqrt (v *. (2. -. (v *. k)) /. (2. -. k)) in
  let at_b = 1. -. (v *. k) -. (at_x *. (1. -. k)) in
  let d = Vec.along (Vec.scale at_b t.b) x at_x in
  match Dir.of_vec d with Some d -> d | None -> Dir.of_vec_or Dir.z t.b
