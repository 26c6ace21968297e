open Candor_number
open Candor_oracle
open Numbers

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
      Law.example "the fused product is there" kahan;
    ] )
