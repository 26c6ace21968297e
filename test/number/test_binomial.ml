open Candor_number
open Candor_oracle
open Numbers
open QCheck2

(* What other software, mpmath of Python, computes with 45 digits. *)

(* Successes, trials, probability, two-sided test. *)
let tests =
  [
    (0, 10, 0.1, 6.9735688019999995699e-1);
    (3, 10, 0.5, 3.4375e-1);
    (10, 10, 0.5, 1.953125e-3);
    (0, 1, 0.3, 1.0);
    (68, 100, 0.68, 1.0);
    (55, 100, 0.68, 8.8357636850332826995e-3);
    (950, 1000, 0.95, 1.0);
    (930, 1000, 0.95, 6.9487173976922912509e-3);
    (2000, 2000, 0.99, 3.7275132059844665986e-9);
    (1923, 2000, 0.99, 2.5411513492540853555e-22);
    (1, 3000, 1e-09, 5.999991003008991369e-6);
    (499000, 1000000, 0.5, 4.560829986538208642e-2);
    (699990000, 1000000000, 0.7, 4.9017314204829764742e-1);
    (700400000, 1000000000, 0.7, 9.402952155105987547e-168);
  ]

(* Confidence, successes, trials, least and greatest probability. *)
let intervals =
  [
    (0.95, 0, 10, 0.0, 3.0849710781876076249e-1);
    (0.95, 3, 10, 6.6739511177734489572e-2, 6.5245285005999724103e-1);
    (0.95, 10, 10, 6.9150289218123923751e-1, 1.0);
    (0.999, 68, 100, 5.1229709956023727866e-1, 8.2034264660959214501e-1);
    (0.5, 1, 1, 2.5e-1, 1.0);
    (0.999, 1, 2000, 2.500624895755196232e-7, 4.9881074401035816982e-3);
    (0.99, 1979, 2000, 9.8209402176297141816e-1, 9.9445297519859942978e-1);
    ( 0.9999999999990905,
      1000,
      2000,
      4.2040350408727206016e-1,
      5.7959649591272793984e-1 );
    (0.999, 1360, 2000, 6.4478998440707409093e-1, 7.1383916479033802256e-1);
  ]

let test () =
  List.iter
    (fun (successes, n, p, truth) ->
      let within =
        0x1p-50 *. (4. -. log truth) *. (1. +. (sqrt (float_of_int n) /. 16.))
      in
      agree ~within
        (Printf.sprintf "%d of %d at %g" successes n p)
        (Binomial.test ~successes n p)
        truth)
    tests

let interval () =
  List.iter
    (fun (confidence, successes, n, least, greatest) ->
      let name = Printf.sprintf "%g %d of %d" confidence successes n in
      let l, g = Binomial.interval ~confidence ~successes n in
      agree ~within:0x1p-46 (name ^ ", least") l least;
      agree ~within:0x1p-46 (name ^ ", greatest") g greatest)
    intervals

let trials =
  let open Gen in
  let* n = int_range 1 300 in
  let* k = int_range 0 n in
  triple (return k) (return n) (Draw.uniform 0. 1.)

let print = Print.(triple int int (Printf.sprintf "%h"))
let law = Law.law ~count:1000 ~print

(* The sum of both tails' terms, by exact rationals. *)
let exact k n p =
  let p = Exact.q p in
  let q = Q.sub Q.one p in
  let rec power x i = if i = 0 then Q.one else Q.mul x (power x (i - 1)) in
  let term i =
    let ways = Q.of_bigint (Z.bin (Z.of_int n) i) in
    Q.mul ways (Q.mul (power p i) (power q (n - i)))
  in
  let sum lo hi =
    List.fold_left
      (fun s i -> Q.add s (term i))
      Q.zero
      (List.init (hi - lo + 1) (fun i -> lo + i))
  in
  Q.min Q.one (Q.mul (Q.of_int 2) (Q.min (sum 0 k) (sum k n)))

let exactly (k, n, p) =
  let n = 1 + (n / 12) in
  let k = min k n in
  let p = Float.round (Float.ldexp p 20) *. 0x1p-20 in
  let truth = Q.to_float (exact k n p) in
  close
    (0x1p-47 *. (1. -. log (Float.max truth 0x1p-1022)))
    (Binomial.test ~successes:k n p)
    truth

let mirrored (k, n, c) =
  let least, greatest = Binomial.interval ~confidence:c ~successes:k n in
  let l, g = Binomial.interval ~confidence:c ~successes:(n - k) n in
  let same x y = Float.abs (x -. y) <= 0x1p-48 in
  same (1. -. g) least && same (1. -. greatest) l

(* Just inside the interval not rejected, just outside rejected. *)
let dual (k, n, c) =
  let c = 0.5 +. (0.499 *. c) in
  let least, greatest = Binomial.interval ~confidence:c ~successes:k n in
  let p x = Binomial.test ~successes:k n x in
  let step = 0x1p-30 in
  let rejected x = p x < 1. -. c in
  (k = 0
  || rejected (least *. (1. -. step))
     && not (rejected (least +. (step *. (1. -. least) *. least))))
  && (k = n
     || rejected (greatest +. (step *. (1. -. greatest)))
        && not (rejected (greatest -. (step *. (1. -. greatest)))))

let ends () =
  let t (k, n, p) = Binomial.test ~successes:k n p in
  Alcotest.(check (list (float 0.)))
    "tests"
    [ 1.; 1.; 0.; 1.; 0.; nan; nan; nan; nan; nan ]
    (List.map t
       [
         (0, 0, 0.5);
         (0, 5, 0.);
         (1, 5, 0.);
         (5, 5, 1.);
         (4, 5, 1.);
         (-1, 5, 0.5);
         (6, 5, 0.5);
         (3, 5, -0.1);
         (3, 5, nan);
         (0, max_int, 0.5);
       ]);
  let i (c, k, n) = Binomial.interval ~confidence:c ~successes:k n in
  Alcotest.(check (list (pair (float 0.) (float 0.))))
    "intervals"
    [ (0., 1.); (0., 1.); (nan, nan); (nan, nan); (nan, nan) ]
    (List.map i
       [ (0.95, 0, 0); (1., 3, 10); (0.95, 3, 2); (nan, 1, 2); (1.1, 1, 2) ])

let suite =
  ( "binomial distribution",
    [
      Law.example "tests agree with mpmath's" test;
      Law.example "intervals agree with mpmath's within 2^-46" interval;
      Law.law ~count:500 ~print "a test is the exact sum of its terms" trials
        exactly;
      law "failures are successes the other way round" trials mirrored;
      law "an interval holds what its test does not reject" trials dual;
      Law.example "ends are exact, what is outside is not a number" ends;
    ] )
