open Candor_space
open Candor_surface
open Candor_number
open Candor_oracle
open Candor_surface_families
open QCheck2

let v = Vec.v

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

(* {1 In twice the precision} *)

(* [a + low] with [low] below half an ulp, as rays in groups have it. *)
type pair = { high : Vec.t; low : Vec.t }

let exact { high; low } = Exact.(add (vec high) (vec low))

let pair_of high =
  let open Gen in
  let* share = Draw.vec (Draw.uniform (-0.5) 0.5) and* none = bool in
  let low x k = if none then 0. else k *. Exact.ulp x in
  let { Vec.x; y; z } = high in
  return { high; low = v (low x share.x) (low y share.y) (low z share.z) }

(* The sum of absolute terms, never more than by the triangle inequality. *)
let near { Error_free.hi; lo } truth terms =
  Q.leq
    Exact.(Q.abs (q hi + q lo - truth))
    Exact.((power (-100) * terms) + power (-1000))

let closely (shape, (y, d)) =
  let f = Form.of_shape shape in
  let ey = exact y and ed = exact d in
  let open Exact in
  let g = vec (Form.slope f) in
  let image = Exact_quadric.image f in
  let ys = size ey and ds = size ed in
  let am = q f.a_size and gm = q f.g_size in
  near (Form.bend f d.high d.low) (dot ed (image ed)) (am * ds * ds)
  && near
       (Form.rise f y.high y.low d.high d.low)
       (dot ed (add (image ey) g))
       (ds * ((am * ys) + gm))
  && near
       (Form.value f y.high y.low)
       (dot ey (add (image ey) (scale two g)) + q f.k)
       ((am * ys * ys) + (two * gm * ys) + Q.abs (q f.k))

(* {1 In doubles} *)

let each_within k (a : Vec.t) (b : Exact.vec) (most : Exact.vec) =
  let near x y m = Q.leq Exact.(Q.abs (q x - y)) Exact.(k * m) in
  near a.x b.x most.x && near a.y b.y most.y && near a.z b.z most.z

(* A, g and y with all signs taken away. *)
let absolute_terms (f : Form.t) (y : Vec.t) =
  let abs x = Q.abs (Exact.q x) in
  let row a b c g =
    Exact.((abs a * abs y.x) + (abs b * abs y.y) + (abs c * abs y.z) + abs g)
  in
  Exact.v
    (row f.axx f.axy f.axz f.gx)
    (row f.axy f.ayy f.ayz f.gy)
    (row f.axz f.ayz f.azz f.gz)

let plainly (shape, ({ high = y; _ }, _)) =
  let f = Form.of_shape shape in
  let terms = absolute_terms f y and u = Exact.power (-50) in
  let image = Exact_quadric.image f (Exact.vec y) in
  let slope = Exact.vec (Form.slope f) in
  each_within u (Form.gradient_size f y) terms terms
  && each_within u (Form.times f y) image terms
  && each_within u (Form.gradient f y) (Exact.add image slope) terms

let kinds () =
  let check name shape ~linear ~constant =
    let f = Form.of_shape shape in
    Alcotest.(check (pair bool bool))
      name (linear, constant)
      (Form.is_linear f, Form.is_constant f)
  in
  let form = Quadrics.form in
  check "a plane" ~linear:true ~constant:false
    (Plane { normal = v 0. 1e-300 0.; offset = 5. });
  check "a ball" ~linear:false ~constant:false (form 1. 1. 1. Vec.zero (-1.));
  check "a pair of planes" ~linear:false ~constant:false
    (form 0. 0. 1e-300 Vec.zero (-1.));
  check "a plane by its form" ~linear:true ~constant:false
    (form 0. 0. 0. (v 0. 0. 1.) 0.);
  check "nothing" ~linear:true ~constant:true (form 0. 0. 0. Vec.zero (-1.))

let centers () =
  let check name shape (at : Point.t) (slope : Vec.t) =
    let f = Form.of_shape shape in
    Alcotest.(check bool) name true (Point.equal (Form.center f) at);
    Alcotest.(check bool) name true (Vec.equal (Form.slope f) slope)
  in
  let p = Point.v in
  check "an ellipsoid"
    (Ellipsoid { center = p 1. 2. 3.; radii = v 1. 2. 3. })
    (p 1. 2. 3.) Vec.zero;
  check "a cone is written about its apex"
    (Cone { apex = p 1. 2. 3.; base = p 4. 5. 6.; radius = 1. })
    (p 1. 2. 3.) Vec.zero;
  check "a plane about the origin"
    (Plane { normal = v 2. 4. 6.; offset = 5. })
    Point.origin (v 1. 2. 3.);
  check "a form about the origin"
    (Quadrics.form 1. 1. 0. (v 0. 0. 0.5) 0.)
    Point.origin (v (-0.) (-0.) (-0.5))

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
let show_pair { high; low } = Draw.show_vec high ^ " + " ^ Draw.show_vec low

let show_pairs (shape, (y, d)) =
  Printf.sprintf "%s\nat %s along %s"
    (Quadrics.show_shape shape)
    (show_pair y) (show_pair d)

let shapes =
  let random =
    Gen.map
      (fun (c : Quadric.t Family.case) -> Quadric.shape c.shape)
      Quadrics.random.cases
  in
  Gen.oneof [ Quadrics.named; random ]

let cases = Gen.pair shapes Draw.ray

let pairs =
  let place = Gen.(Draw.vec Draw.coordinate >>= pair_of) in
  Gen.(pair shapes (pair place place))

let law name = Law.law ~count:2000 ~print:show name cases
let pair_law name = Law.law ~count:2000 ~print:show_pairs name pairs

let suite =
  ( "form",
    [
      law "its terms along a ray are exact in expansions" exactly;
      pair_law
        "value, rise and bend are right within 2^-100 of their size, for pairs \
         of doubles"
        closely;
      pair_law "images and gradients are right within 2^-50 of their terms"
        plainly;
      law "its sizes bound its coefficients" sizes;
      Law.example "planes are linear, and what is nothing is constant" kinds;
      Law.example "it is written about the shape's own centre" centers;
    ] )
