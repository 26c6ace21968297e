open Candor_number
open Candor_oracle
open Numbers
module D = Double_double

let double =
  let open QCheck2.Gen in
  let* hi = real and* tail = Draw.uniform (-0.5) 0.5 in
  let* k = Draw.either 60 (return 0) (int_range 0 40) in
  let lo = Float.ldexp (tail *. Exact.ulp hi) (-k) in
  let lo = if Float.abs lo < 0x1p-330 || hi = 0. then 0. else lo in
  return (Error_free.two_sum hi lo)

let show { Error_free.hi; lo } = Printf.sprintf "%h + %h" hi lo
let show2 (a, b) = show a ^ ", " ^ show b

(* n u^2 *)
let ulps2 n = Exact.(Q.of_int n * power (-106))

let binary name operation truth bound ~where =
  Law.law ~count:20000 ~print:show2 name (pair double) (fun (a, b) ->
      (not (where b))
      || relative (ulps2 bound)
           (exactly (operation a b))
           (truth (exactly a) (exactly b)))

let anywhere _ = true
let nonzero { Error_free.hi; _ } = hi <> 0.
let unary name holds = Law.law ~count:20000 ~print:show name double holds

let rounds a =
  let x = D.to_float a in
  Q.leq Exact.(Q.abs (q x - exactly a)) Exact.(q (Exact.ulp x) / two)

let conversions a =
  Q.equal (exactly (D.neg a)) (Q.neg (exactly a))
  && Q.equal (exactly (D.of_float a.Error_free.hi)) (Exact.q a.Error_free.hi)

let vec =
  QCheck2.Gen.map
    (fun ((x, y), z) -> { D.x; y; z })
    (QCheck2.Gen.pair (pair double) double)

let show_vec { D.x; y; z } = String.concat ", " (List.map show [ x; y; z ])
let exact_vec { D.x; y; z } = Exact.v (exactly x) (exactly y) (exactly z)

let dot (a, b) =
  let a' = exact_vec a and b' = exact_vec b in
  let abs (v : Exact.vec) = Exact.v (Q.abs v.x) (Q.abs v.y) (Q.abs v.z) in
  let terms = Exact.dot (abs a') (abs b') in
  Q.leq (Q.abs Exact.(exactly (D.dot a b) - dot a' b')) Exact.(ulps2 12 * terms)

let suite =
  ( "double-double",
    [
      binary "a sum is right within 4u²" D.add Q.add 4 ~where:anywhere;
      binary "a difference is right within 4u²" D.sub Q.sub 4 ~where:anywhere;
      binary "a product is right within 5u²" D.mul Q.mul 5 ~where:anywhere;
      binary "a quotient is right within 15u²" D.div Q.div 15 ~where:nonzero;
      binary "a multiple is right within 2u²"
        (fun a b -> D.scale b.Error_free.hi a)
        (fun a b -> Q.mul a (Exact.q (Q.to_float b)))
        2
        ~where:(fun b -> b.Error_free.hi = D.to_float b);
      unary "it is rounded to the nearest double" rounds;
      unary "negation and conversions are exact" conversions;
      Law.law ~count:10000
        ~print:(fun (a, b) -> show_vec a ^ "; " ^ show_vec b)
        "a scalar product is right within 12u² of its terms" (pair vec) dot;
    ] )
