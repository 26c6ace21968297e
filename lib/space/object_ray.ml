open Candor_number

type t = {
  origin : Point.t;
  direction : Vec.t;
  origin_low : Vec.t;
  direction_low : Vec.t;
  exact : bool;
}

let is_zero (a : Vec.t) = a.x = 0. && a.y = 0. && a.z = 0.

let of_ray ({ origin; direction; direction_low; _ } : Ray.t) =
  {
    origin;
    direction;
    origin_low = Vec.zero;
    direction_low;
    exact = is_zero direction_low;
  }

let v origin direction = of_ray (Ray.v origin direction)

let through m r =
  let origin, origin_low, direction, direction_low =
    Wide_affine.ray m r.origin r.origin_low r.direction r.direction_low
  in
  let exact = is_zero origin_low && is_zero direction_low in
  { origin; direction; origin_low; direction_low; exact }

let ldexp ~length ~time r =
  {
    r with
    origin = Point.ldexp length r.origin;
    origin_low = Vec.ldexp length r.origin_low;
    direction = Vec.ldexp time r.direction;
    direction_low = Vec.ldexp time r.direction_low;
  }

let plus (a : Expansion.vec) (b : Vec.t) =
  let open Expansion in
  {
    x = add a.x (of_float b.x);
    y = add a.y (of_float b.y);
    z = add a.z (of_float b.z);
  }

let from r p = plus (Unrounded.diff r.origin p) r.origin_low
let toward r = plus (Unrounded.vec r.direction) r.direction_low

let offset r p =
  let f = Point.sub r.origin p in
  (f, Vec.add (Unrounded.diff_error r.origin p f) r.origin_low)

(* The first step is off by its own rounding, the second by the square of that. *)
let closest r p =
  let f, rest = offset r p in
  let d = r.direction in
  let d2 = Vec.dot d d in
  let y = Vec.add (Vec.along f d (-.Vec.dot f d /. d2)) rest in
  Vec.along y d (-.Vec.dot y d /. d2)

let near_one r =
  let e = Vec.exponent r.direction in
  (ldexp ~length:0 ~time:(-e) r, e)

let pair_from r p =
  let f = Unrounded.pair_diff r.origin p in
  if r.exact then f
  else
    let low x = Double_double.of_float x and { Vec.x; y; z } = r.origin_low in
    let open Double_double in
    { x = add f.x (low x); y = add f.y (low y); z = add f.z (low z) }

let pair_near_one r =
  let { direction = d; direction_low = l; _ }, e = near_one r in
  let pair hi lo = { Error_free.hi; lo } in
  ({ Double_double.x = pair d.x l.x; y = pair d.y l.y; z = pair d.z l.z }, e)
