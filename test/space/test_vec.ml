open Candor_space
open Candor_oracle
open Places
open QCheck2

let pair g = Gen.pair g g
let show2 (a, b) = show a ^ " " ^ show b

let antisymmetric (a, b) =
  let c = Vec.cross a b and d = Vec.cross b a in
  Vec.compare (Vec.neg c) d = 0

(* Each component is off by two roundings of each product and one of the sum. *)
let cross_is_near (a, b) =
  let c = Exact.vec (Vec.cross a b) in
  let exact = Exact.(cross (vec a) (vec b)) in
  let terms = Exact.(size (vec a) * size (vec b)) in
  Q.leq (Exact.largest (Exact.sub c exact)) Exact.(power (-51) * terms)

let dot_is_near (a, b) =
  let exact = Exact.(dot (vec a) (vec b)) in
  let terms = Exact.(size (vec a) * size (vec b)) in
  Q.leq
    (Q.abs (Q.sub (Exact.q (Vec.dot a b)) exact))
    Exact.(power (-51) * terms)

(* Within 3 ulp, unless the length itself is too large. *)
let norm a =
  let n = Vec.norm a in
  let s = squares a in
  if not (Float.is_finite n) then Q.geq s (Exact.power 2048)
  else
    let k = 3. *. Exact.ulp n in
    Q.leq
      (let x = Exact.q (Float.max 0. (n -. k)) in
       Q.mul x x)
      s
    && Q.geq
         (let x = Exact.q (n +. k) in
          Q.mul x x)
         s

let largest a =
  Float.equal (Vec.largest a)
    (Float.max (Float.abs a.Vec.x) (Float.max (Float.abs a.y) (Float.abs a.z)))
  && List.for_all
       (fun i -> Float.abs (Vec.get a i) <= Vec.largest a)
       [ 0; 1; 2 ]

let examples () =
  let check name expected found =
    Alcotest.(check (float 0.)) name expected found
  in
  check "tiny" 5e-324 (Vec.norm (Vec.v 0. 5e-324 0.));
  check "huge" 1e300 (Vec.norm (Vec.v 0. 0. (-1e300)));
  check "3 4 12" 13e200 (Vec.norm (Vec.v 3e200 4e200 12e200));
  check "zero" 0. (Vec.norm (Vec.v 0. (-0.) 0.));
  Alcotest.(check bool)
    "x cross y is z" true
    (Vec.equal (Vec.cross (Vec.v 1. 0. 0.) (Vec.v 0. 1. 0.)) (Vec.v 0. 0. 1.));
  List.iter
    (fun x ->
      Alcotest.(check bool) "not finite" false (Vec.is_finite (Vec.v 0. x 0.)))
    [ nan; infinity; neg_infinity ]

let law name gen print holds = Law.law ~count:5000 ~print name gen holds

let suite =
  ( "vectors",
    [
      law "a × b is exactly −(b × a)" (pair vec) show2 antisymmetric;
      law "a cross product is off by roundings of its terms" (pair ordinary)
        show2 cross_is_near;
      law "a scalar product is off by roundings of its terms" (pair ordinary)
        show2 dot_is_near;
      law "a length is right within 3 ulp at any size" vec show norm;
      law "the largest component is" vec show largest;
      Law.example "lengths of the largest and the smallest" examples;
    ] )
