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

let rounded_once ((a, d), t) =
  let b = Vec.along a d t in
  let exact = Exact.(along (vec a) (vec d) (q t)) in
  let same x y = Float.equal x (Q.to_float y) in
  same b.x exact.x && same b.y exact.y && same b.z exact.z

(* What leaves the range of doubles is rounded like anything else. *)
let shifted (a, e) =
  let b = Vec.ldexp e a in
  let same x y = Float.equal x (Q.to_float Exact.(power e * q y)) in
  same b.x (a : Vec.t).x && same b.y a.y && same b.z a.z

let absolute a =
  let { Vec.x; y; z } = a and b = Vec.abs a in
  let is x y = (not (Float.sign_bit x)) && (x = y || x = -.y) in
  is b.x x && is b.y y && is b.z z

(* Two additions, each rounded. *)
let norm1_is_near a =
  let exact = Exact.(size (vec a)) and found = Exact.q (Vec.norm1 a) in
  Q.leq (Q.abs (Q.sub found exact)) Exact.(power (-52) * exact)

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
      law "a vector along another is rounded once"
        (Gen.pair (pair ordinary) (Draw.uniform (-9.) 9.))
        (fun (ab, t) -> Printf.sprintf "%s %h" (show2 ab) t)
        rounded_once;
      law "ldexp multiplies by a power of two"
        (Gen.pair Places.vec (Gen.int_range (-900) 900))
        (fun (a, e) -> Printf.sprintf "%s by 2^%d" (show a) e)
        shifted;
      law "abs takes signs away, from zeros too" vec show absolute;
      law "norm1 is the sum of the absolute components" ordinary show
        norm1_is_near;
      Law.example "lengths of the largest and the smallest" examples;
    ] )
