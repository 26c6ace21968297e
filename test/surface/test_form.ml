open Candor_space
open Candor_surface
open Candor_number
open Candor_oracle
open Candor_surface_families
open QCheck2

let terms (shape, (ray : Ray.t)) =
  let f = Form.of_shape shape in
  let c = Form.center f in
  let offset = Exact.sub (Exact.point ray.origin) (Exact.point c) in
  (f, c, ray, offset, Exact_quadric.equation f (Crossing.line ray))

let exactly case =
  let f, c, { Ray.origin = o; direction = d; _ }, _, (a, b, k) = terms case in
  let open Expansion in
  let p = { x = diff o.x c.x; y = diff o.y c.y; z = diff o.z c.z } in
  let d = { x = of_float d.x; y = of_float d.y; z = of_float d.z } in
  let a', b', k' = Form.along_exactly f p d in
  let same x y = sign x = Q.sign y && Exact.within 1. (to_float x) y in
  same a' a && same b' b && same k' k

(* Within 2^-100 of the terms that are added up. *)
let closely case =
  let f, c, { Ray.origin = o; direction = d; _ }, offset, (a, b, k) =
    terms case
  in
  let exact_d = Exact.vec d in
  let x = Error_free.two_diff o.x c.x
  and y = Error_free.two_diff o.y c.y
  and z = Error_free.two_diff o.z c.z in
  let p = Vec.v x.hi y.hi z.hi and p' = Vec.v x.lo y.lo z.lo in
  let found_a = Form.bend f d Vec.zero
  and found_b = Form.rise f p p' d Vec.zero
  and found_c = Form.value f p p' in
  let value { Error_free.hi; lo } = Exact.(q hi + q lo) in
  let near x y terms =
    Q.leq Exact.(Q.abs (value x - y)) Exact.(power (-100) * terms)
  in
  let open Exact in
  let ps = size offset and ds = size exact_d in
  let am = q f.a_size and gm = q f.g_size in
  near found_a a (am * ds * ds)
  && near found_b b (ds * ((am * ps) + gm))
  && near found_c k ((am * ps * ps) + (two * gm * ps) + Q.abs (q f.k))

let sizes (shape, _) =
  let f = Form.of_shape shape in
  let square x = Exact.(q x * q x) in
  let open Exact in
  let a =
    square f.axx + square f.ayy + square f.azz
    + (two * (square f.axy + square f.axz + square f.ayz))
  and g = square f.gx + square f.gy + square f.gz in
  let slack = one + power (-50) in
  Q.leq a (slack * square f.a_size) && Q.leq g (slack * square f.g_size)

let show (shape, ray) = Quadrics.show_shape shape ^ "\n" ^ Draw.show_ray ray

let cases =
  let random =
    Gen.map
      (fun (c : Quadric.t Family.case) -> Quadric.shape c.shape)
      Quadrics.random.cases
  in
  Gen.pair (Gen.oneof [ Quadrics.named; random ]) Draw.ray

let law name = Law.law ~count:2000 ~print:show name cases

let suite =
  ( "form",
    [
      law "its terms along a ray are exact in expansions" exactly;
      law "its terms along a ray are right within 2^-100 of their size" closely;
      law "its sizes bound its coefficients" sizes;
    ] )
