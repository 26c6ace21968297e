open Candor_number
open Candor_oracle
open Numbers
open QCheck2

(* What other software, mpmath of Python, computes with 45 digits. *)

(* Degrees of freedom, x, lower and upper tail. *)
let tails =
  [
    (1.0, 1e-300, 7.9788456080286536588e-151, 1.0);
    (1.0, 0.001, 2.522712063003961172e-2, 9.7477287936996038828e-1);
    (1.0, 3.84, 9.4995647875129489681e-1, 5.0043521248705103189e-2);
    (1.0, 1300.0, 1.0, 1.1303728441492742445e-284);
    (1.5, 0.2, 1.8545356674668446771e-1, 8.1454643325331553229e-1);
    (2.0, 1.0, 3.934693402873665764e-1, 6.065306597126334236e-1);
    (2.37, 9.0, 9.8352431760258058366e-1, 1.647568239741941634e-2);
    (3.0, 1e-100, 2.6596152026762179327e-151, 1.0);
    (7.77, 4.0, 1.5847911964812865613e-1, 8.4152088035187134387e-1);
    (10.0, 18.3, 9.4989093858853754841e-1, 5.0109061411462451593e-2);
    (30.0, 200.0, 1.0, 4.9527335290031906019e-27);
    (99.5, 101.4, 5.7183440256231069162e-1, 4.2816559743768930838e-1);
    (99.5, 30.0, 1.2284051503213779784e-12, 9.9999999999877159485e-1);
    (1000.0, 1000.0, 5.0594714617076035805e-1, 4.9405285382923964195e-1);
    (1000.0, 2500.0, 1.0, 2.1059268048481404677e-129);
    (12345.6, 12000.0, 1.3345606796607437959e-2, 9.8665439320339256204e-1);
    (1000000.0, 1002000.0, 9.2128133861387036661e-1, 7.8718661386129633385e-2);
    (1000000.0, 960000.0, 4.5185935272229160323e-181, 1.0);
    ( 1000000000.0,
      1000000000.0,
      5.0000594708038724198e-1,
      4.9999405291961275802e-1 );
    ( 1000000000.0,
      1000100000.0,
      9.8732438800506444339e-1,
      1.2675611994935556605e-2 );
    (1000000000.0, 998400000.0, 6.33379459733109079e-281, 1.0);
  ]

(* Degrees of freedom, p, quantile. *)
let quantiles =
  [
    (1.0, 1e-20, 1.5707963267948964469e-40);
    (1.0, 0.005, 3.927042222051590377e-5);
    (1.0, 0.3, 1.4847186183254543808e-1);
    (1.0, 0.5, 4.5493642311957275194e-1);
    (1.0, 0.77, 1.4408613880531481631);
    (1.0, 0.995, 7.8794385766224157511);
    (1.0, 0.9999999999990905, 5.103033566749730281e1);
    (1.5, 1e-20, 3.8502601477613108305e-27);
    (1.5, 0.005, 1.5286441971937114235e-3);
    (1.5, 0.3, 4.0158921012661378939e-1);
    (1.5, 0.5, 9.0833395664771217176e-1);
    (1.5, 0.77, 2.2135444639199597134);
    (1.5, 0.995, 9.331022026621364449);
    (1.5, 0.9999999999990905, 5.3385019489626455996e1);
    (2.0, 1e-300, 2.0000000000000000501e-300);
    (2.0, 1e-20, 1.9999999999999998903e-20);
    (2.0, 0.005, 1.0025083647088564295e-2);
    (2.0, 0.3, 7.133498878774647261e-1);
    (2.0, 0.5, 1.3862943611198906188);
    (2.0, 0.77, 2.9393519401178835089);
    (2.0, 0.995, 1.0596634733096071579e1);
    (2.0, 0.9999999999990905, 5.5451774444795624753e1);
    (4.7, 1e-300, 6.8158605390379014202e-128);
    (4.7, 1e-20, 9.6041042703273120765e-9);
    (4.7, 0.005, 3.4361672762536423576e-1);
    (4.7, 0.3, 2.7556029086441449154);
    (4.7, 0.5, 4.0527713153999613069);
    (4.7, 0.77, 6.500603954601072365);
    (4.7, 0.995, 1.619380300869549347e1);
    (4.7, 0.9999999999990905, 6.4545253134714700425e1);
    (29.0, 1e-300, 2.5479509703621747648e-20);
    (29.0, 1e-20, 5.2960430960653457804e-1);
    (29.0, 0.005, 1.3121148887960399087e1);
    (29.0, 0.3, 2.4576987683681221561e1);
    (29.0, 0.5, 2.8336126866584449894e1);
    (29.0, 0.77, 3.4256350104868877425e1);
    (29.0, 0.995, 5.2335617785933617037e1);
    (29.0, 0.9999999999990905, 1.1842130772052377788e2);
    (100.25, 1e-300, 4.0428451875171775297e-5);
    (100.25, 1e-20, 1.8707846086657829319e1);
    (100.25, 0.005, 6.7532070432515880558e1);
    (100.25, 0.3, 9.2369643545820135948e1);
    (100.25, 0.5, 9.9584127236793853403e1);
    (100.25, 0.77, 1.1037229802630197797e2);
    (100.25, 0.995, 1.4046502279997972817e2);
    (100.25, 0.9999999999990905, 2.3450615580791846905e2);
    (12345.6, 1e-300, 7.4004605318796754865e3);
    (12345.6, 1e-20, 1.0946170432190350783e4);
    (12345.6, 0.005, 1.1944605966319588091e4);
    (12345.6, 0.3, 1.2262717836066143812e4);
    (12345.6, 0.5, 1.2344933339733753182e4);
    (12345.6, 0.77, 1.2461392105795475212e4);
    (12345.6, 0.995, 1.2754107099133649663e4);
    (12345.6, 0.9999999999990905, 1.3485692008281783895e4);
    (1000000000.0, 1e-20, 9.995858320840524584e8);
    (1000000000.0, 0.3, 9.9997654761279567535e8);
    (1000000000.0, 0.9999999999990905, 1.0003152151846452799e9);
  ]

let tail () =
  List.iter
    (fun (dof, x, lower, upper) ->
      let near name got truth =
        let within = 0x1p-48 -. (0x1p-51 *. log truth) in
        agree ~within (Printf.sprintf "%s %g %h" name dof x) got truth
      in
      near "lower" (Chi_square.cdf ~dof x) lower;
      near "upper" (Chi_square.upper ~dof x) upper)
    tails

let quantile () =
  List.iter
    (fun (dof, p, x) ->
      let within = 0x1p-48 -. (0x1p-51 *. log p) in
      agree ~within
        (Printf.sprintf "%g %h" dof p)
        (Chi_square.quantile ~dof p)
        x)
    quantiles

let dof = Draw.(wide 0. 4.)
let print = show2
let law = Law.law ~count:1000 ~print

(* An ulp of x is as many of the tail as d log p/d log x, at most about dof or x
   above the mean. *)
let identity (dof, p) =
  let x = Chi_square.quantile ~dof p in
  let back = Chi_square.cdf ~dof x in
  let scale = 1. +. dof +. Float.abs (log p) in
  close (0x1p-49 *. scale) back p

let two (x, p) =
  (* Of two degrees, the tail is e^(-x/2). *)
  ignore p;
  close (0x1p-48 *. (1. +. x)) (Chi_square.upper ~dof:2. x) (exp (-.x /. 2.))

let normal (_, x) =
  let x = 37. *. x in
  close
    (0x1p-48 *. (1. +. (x *. x)))
    (Chi_square.upper ~dof:1. (x *. x))
    (2. *. Normal.cdf (-.x))

let recurrence (dof, u) =
  (* Q(a + 1, x) - Q(a, x) is x^a e^-x/Γ(a + 1), a density. *)
  let x = 3. *. dof *. u in
  let { Incomplete.upper; slope; _ } = Incomplete.gamma (dof /. 2.) (x /. 2.) in
  let next = Chi_square.upper ~dof:(dof +. 2.) x in
  Float.abs (next -. upper -. (slope /. (dof /. 2.))) <= 0x1p-46

let ends () =
  let inf = infinity in
  let cdf (dof, x) = Chi_square.cdf ~dof x in
  let quantile (dof, p) = Chi_square.quantile ~dof p in
  Alcotest.(check (list (float 0.)))
    "ends"
    [ 0.; 1.; 1.; nan; nan; nan; nan; nan; 0.; inf; nan; nan; nan; nan; 0. ]
    (List.map cdf
       [
         (3., 0.);
         (3., inf);
         (3., 1e308);
         (3., -1.);
         (3., nan);
         (0.5, 1.);
         (0x1p42, 1.);
         (nan, 1.);
       ]
    @ List.map quantile
        [ (3., 0.); (3., 1.); (3., -0.1); (3., nan); (0., 0.5); (1e20, 0.5) ]
    @ [ Chi_square.upper ~dof:3. inf ])

let suite =
  ( "chi-square distribution",
    [
      Law.example "tails agree with mpmath's within 2^-48 + 2^-51·|ln|" tail;
      Law.example "quantiles agree with mpmath's within 2^-48 + 2^-51·|ln p|"
        quantile;
      law "the probability of a quantile is what it is the quantile of"
        (Gen.pair dof (Draw.uniform 0x1p-20 1.))
        identity;
      law "the square of a normal variable has one degree of freedom"
        (Gen.pair dof (Draw.uniform 0. 1.))
        normal;
      law "two degrees of freedom make it exponential"
        (Gen.pair (Draw.uniform 0. 1400.) dof)
        two;
      law "two more degrees of freedom add the density"
        (Gen.pair dof (Draw.uniform 0. 1.))
        recurrence;
      rising "probabilities rise"
        (fun x -> Chi_square.cdf ~dof:7.3 x)
        (Draw.wide (-3.) 2.);
      rising "quantiles rise"
        (fun p -> Chi_square.quantile ~dof:7.3 p)
        (Draw.uniform 0. 1.);
      Law.example "ends are exact, what is outside is not a number" ends;
    ] )
