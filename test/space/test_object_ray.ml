open Candor_number
open Candor_space
open Candor_oracle
open QCheck2

let ray =
  let open Gen in
  let* o = Draw.point Draw.coordinate and* d = Draw.vec Draw.coordinate in
  return (Object_ray.v o d)

let inside =
  let open Gen in
  let* ray = ray and* m = Maps.affine in
  return
    (match Wide_affine.inverse m with
    | Some m -> Object_ray.through m ray
    | None -> ray)

let show (r : Object_ray.t) =
  String.concat " "
    [
      Draw.show_point r.origin;
      Draw.show_vec r.origin_low;
      Draw.show_vec r.direction;
      Draw.show_vec r.direction_low;
    ]

let origin (r : Object_ray.t) =
  Exact.add (Exact.point r.origin) (Exact.vec r.origin_low)

let direction (r : Object_ray.t) =
  Exact.add (Exact.vec r.direction) (Exact.vec r.direction_low)

let equal (a : Exact.vec) (b : Exact.vec) =
  Q.equal a.x b.x && Q.equal a.y b.y && Q.equal a.z b.z

(* An expansion is exactly a rational if what is left of it is 0. *)
let same_number e x =
  let rec rest e x =
    if Expansion.sign e = 0 then Q.sign x = 0
    else
      let part = Expansion.to_float e in
      rest Expansion.(sub e (of_float part)) Exact.(x - q part)
  in
  rest e x

let same (e : Expansion.vec) (v : Exact.vec) =
  same_number e.x v.x && same_number e.y v.y && same_number e.z v.z

let seen_exactly (r, p) =
  same (Object_ray.from r p) (Exact.sub (origin r) (Exact.point p))
  && same (Object_ray.toward r) (direction r)

let pair_of (v : Double_double.vec) =
  let sum (x : Double_double.t) = Exact.(q x.hi + q x.lo) in
  Exact.v (sum v.x) (sum v.y) (sum v.z)

let pair_is_near ((r : Object_ray.t), p) =
  let found = pair_of (Object_ray.pair_from r p) in
  let truth = Exact.sub (origin r) (Exact.point p) in
  if r.exact then equal found truth
  else
    Exact_affine.within (Exact.power (-104)) found truth
      (Exact.add
         (Exact_affine.abs (origin r))
         (Exact_affine.abs (Exact.point p)))

let near_one (r : Object_ray.t) =
  Vec.largest r.direction = 0.
  ||
  let b, e = Object_ray.pair_near_one r in
  let m = Vec.largest (Vec.v b.x.hi b.y.hi b.z.hi) in
  0.5 <= m && m < 1.
  && equal (direction r) (Exact.scale (Exact.power e) (pair_of b))

(* The two parts are the whole, to half an ulp of the second. *)
let offset_is_near ((r : Object_ray.t), p) =
  let y, rest = Object_ray.offset r p in
  let found = Exact.add (Exact.vec y) (Exact.vec rest) in
  let truth = Exact.sub (origin r) (Exact.point p) in
  let rest = Exact.vec rest in
  Exact_affine.within (Exact.power (-52)) found truth (Exact_affine.abs rest)

(* Of lines that pass [p] at a known place, from near and far. *)
let passing =
  let open Gen in
  let* n = Draw.unit
  and* far = Draw.wide 0. 18.
  and* p = Draw.point (Draw.small 9) in
  let* side = Draw.across n in
  return (Object_ray.v (Draw.move (Draw.move p side 0.5) n (-.far)) n, p)

let closest_is_near ((r : Object_ray.t), p) =
  let open Exact in
  let y = Object_ray.closest r p in
  let d = direction r and f = sub (origin r) (point p) in
  let truth = sub f (scale (dot f d / dot d d) d) in
  let off = sub (vec y) truth in
  Q.leq (largest off) ((power (-50) * size truth) + (power (-100) * size f))

let near_one_is_the_same (r : Object_ray.t) =
  Vec.largest r.direction = 0.
  ||
  let near, e = Object_ray.near_one r in
  let m = Vec.largest near.direction in
  0.5 <= m && m < 1.
  && equal (direction r) (Exact.scale (Exact.power e) (direction near))
  && equal (origin r) (origin near)

let exact_when (r : Object_ray.t) =
  let zero (a : Vec.t) = Vec.largest a = 0. in
  Bool.equal r.exact (zero r.origin_low && zero r.direction_low)

let rescaled r =
  let s = Object_ray.ldexp ~length:5 ~time:(-7) r in
  equal (origin s) (Exact.scale (Exact.power 5) (origin r))
  && equal (direction s) (Exact.scale (Exact.power (-7)) (direction r))

(* A ray that is aimed at a point keeps what rounding took from it. *)
let as_given ((r : Ray.t), p) =
  let keeps (r : Ray.t) =
    let s = Object_ray.of_ray r in
    let zero = Vec.equal s.origin_low Vec.zero in
    zero && exact_when s
    && Point.equal s.origin r.origin
    && Vec.equal s.direction r.direction
    && Vec.equal s.direction_low r.direction_low
  in
  keeps r && keeps (Ray.toward p r)

let law name gen print holds = Law.law ~count:5000 ~print name gen holds
let with_point g = Gen.pair g (Draw.point Draw.coordinate)
let show2 (r, p) = show r ^ " from " ^ Draw.show_point p
let any = Gen.oneof [ ray; inside ]

let suite =
  ( "object rays",
    [
      law "are a ray as given, in its own space" (with_point Draw.ray)
        (fun (r, p) -> Draw.show_ray r ^ " toward " ^ Draw.show_point p)
        as_given;
      law "are seen from a point exactly" (with_point any) show2 seen_exactly;
      law "are seen in double-double, exactly where they are doubles"
        (with_point any) show2 pair_is_near;
      law "are offset by a vector and a rest" (with_point any) show2
        offset_is_near;
      law "know their nearest point from however far" passing show2
        closest_is_near;
      law "are brought near 1 by a power of two" any show near_one_is_the_same;
      law "a power of two brings the direction near one" any show near_one;
      law "are exact iff nothing is left beside the doubles" any show exact_when;
      law "are rescaled exactly" any show rescaled;
    ] )
