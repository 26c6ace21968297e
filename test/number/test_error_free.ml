open Candor_number
open Candor_oracle
open Numbers
open QCheck2

let nonoverlapping { Error_free.hi; lo } =
  Float.abs lo <= Exact.ulp hi /. 2. || lo = 0.

let exact name operation truth =
  Law.law ~count:20000 ~print:show2 name (pair real) (fun (a, b) ->
      let s = operation a b in
      Q.equal (exactly s) (truth (Exact.q a) (Exact.q b)) && nonoverlapping s)

let errors_complete (a, b) =
  let open Exact in
  Q.equal (q (a +. b) + q (Error_free.sum_error a b (a +. b))) (q a + q b)
  && Q.equal (q (a *. b) + q (Error_free.product_error a b (a *. b))) (q a * q b)

(* Half of the cases nearly cancel. *)
let near_cancellation =
  let open QCheck2.Gen in
  let* a = real and* b = real and* c = real and* k = int_bound 3 in
  let d = if k = 0 || c = 0. then b else a *. b /. c in
  let d = if Float.is_finite d && Float.abs d > 0x1p-260 then d else b in
  let* d = Draw.nudged (return d) in
  return (a, b, c, in_range d)

let determinant (a, b, c, d) =
  let truth = Exact.((q a * q b) - (q c * q d)) in
  let x = Error_free.difference_of_products a b c d in
  relative (Exact.power (-52)) (Exact.q x) truth
  && Int.compare (Float.compare x 0.) 0 = Q.sign truth

(* Up to the ends of their range, both zeros among them. *)
let mild =
  let open Gen in
  let full =
    let* m = Draw.uniform 1. 2. and* e = int_range (-480) 479 in
    return (Float.ldexp m e)
  in
  let ends =
    Draw.pick [ 0.; Float.succ 0x1p-480; Float.pred 0x1p480; 0x1p-479; 1. ]
  in
  Draw.signed
    (oneof
       [ full; ends; Draw.nudged (Draw.power (-479) 479); Draw.uniform 0. 2. ])

let same x y = Int64.equal (Int64.bits_of_float x) (Int64.bits_of_float y)

let without_fused_product (a, b) =
  let open Error_free in
  let p = a *. b in
  is_mild a && is_mild b
  && same (Float.fma a b (-.p)) (mild_product_error a (head a) b (head b) p)

let dot_without_fused_product ((a, b, c), (x, y, z)) =
  let open Error_free in
  let s = dot a b c x y z in
  same (dot_error a b c x y z s)
    (mild_dot_error a (head a) b (head b) c (head c) x (head x) y (head y) z
       (head z) s)

let mild_ones () =
  let check expected x =
    Alcotest.(check bool)
      (Printf.sprintf "%h" x) expected (Error_free.is_mild x)
  in
  List.iter (check true)
    [ 0.; -0.; 1.; -3.; Float.succ 0x1p-480; -.Float.pred 0x1p480 ];
  List.iter (check false)
    [ nan; infinity; neg_infinity; 0x1p-1074; -0x1p-1022; 0x1p-481; 0x1p480 ];
  List.iter (check false) [ -0x1p1023; max_float ]

let kahan () =
  Alcotest.(check (float 0.))
    "W. Kahan's example" 1.
    (Error_free.difference_of_products 94906267.375 94906267.375 94906266.375
       94906268.375)

let suite =
  ( "error-free transformations",
    [
      exact "two_sum is the sum exactly, its parts apart" Error_free.two_sum
        Q.add;
      exact "two_diff is the difference exactly" Error_free.two_diff Q.sub;
      exact "two_product is the product exactly" Error_free.two_product Q.mul;
      Law.law ~count:20000 ~print:show2
        "a sum and its error, a product and its error are exact" (pair real)
        errors_complete;
      Law.law ~count:20000 ~print:show4
        "a difference of products is right within 2u, its sign always"
        near_cancellation determinant;
      Law.law ~count:100000 ~print:show2
        "errors of products of mild numbers are those of fused products, bit \
         for bit"
        (pair mild) without_fused_product;
      Law.law ~count:20000
        ~print:(fun ((a, b, c), (x, y, z)) ->
          Printf.sprintf "%h %h %h, %h %h %h" a b c x y z)
        "so are those of scalar products"
        (pair (Gen.triple mild mild mild))
        dot_without_fused_product;
      Law.example "zeros are mild, numbers that are huge or tiny are not"
        mild_ones;
      Law.example "the fused product is there" kahan;
    ] )
