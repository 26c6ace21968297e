open Candor_number
open Numbers

(* What other software, mpmath of Python, computes with 45 digits. *)

let cdfs =
  [
    (-38.0, 2.8854283600687843084e-316);
    (-37.7, 2.4834853102775894207e-311);
    (-26.3, 9.5885646850983165318e-153);
    (-12.1, 5.2805587674335603344e-34);
    (-8.3, 5.2055697448902540246e-17);
    (-5.1, 1.6982674071476014616e-7);
    (-3.3, 4.834241423837775071e-4);
    (-1.7, 4.4565462758543043664e-2);
    (-1.0, 1.5865525393145705141e-1);
    (-0.3, 3.8208857781104736693e-1);
    (-0.001, 4.9960105778608893741e-1);
    (1e-09, 5.000000003989422804e-1);
    (0.7, 7.5803634777692697138e-1);
    (1.96, 9.7500210485177956379e-1);
    (4.4, 9.9999458745609229615e-1);
    (8.0, 9.999999999999993779e-1);
  ]

let quantiles =
  [
    (5e-324, -3.8467405617144346251e1);
    (1e-310, -3.7663060331949523732e1);
    (1e-308, -3.7540674921545942401e1);
    (1e-300, -3.7047096299361199237e1);
    (1e-200, -3.0205594179579643063e1);
    (1e-100, -2.1273453560965324294e1);
    (1e-20, -9.2623400897984075796);
    (1e-12, -7.0344838253011319326);
    (1e-11, -6.7060231554951362961);
    (1e-05, -4.2648907939228246102);
    (0.001, -3.0902323061678135354);
    (0.025, -1.9599639845400542118);
    (0.05, -1.644853626951472688);
    (0.0749, -1.4402382675279636631);
    (0.075, -1.4395314709384559349);
    (0.16, -9.9445788320975315405e-1);
    (0.25, -6.744897501960817432e-1);
    (0.3333, -4.3081897699671280761e-1);
    (0.49, -2.5068908258711058033e-2);
    (0.4999999, -2.5066282747031065135e-7);
    (0.5000001, 2.5066282733116483012e-7);
    (0.75, 6.744897501960817432e-1);
    (0.975, 1.9599639845400538556);
    (0.999, 3.0902323061678132778);
    (0.999999999, 5.9978070196016374264);
  ]

let tail = Candor_oracle.Draw.wide (-300.) 0.
let show = Printf.sprintf "%h"
let law = Candor_oracle.Law.law ~print:show

let identity p =
  let p = 0.5 *. p in
  let x = Normal.quantile p in
  (* x = -37 has an ulp of 37² 2^-52 of its tail. *)
  close (0x1p-50 *. (1. +. (x *. x))) (Normal.cdf x) p

let symmetric x =
  (* A multiple of 2^-53, so that 1 - p is exact. *)
  let p = Float.round (Float.ldexp x 53) *. 0x1p-53 in
  Normal.quantile p = -.Normal.quantile (1. -. p)
  && Float.abs (Normal.cdf (8. *. p) +. Normal.cdf (-8. *. p) -. 1.) <= 0x1p-52

let ends () =
  Alcotest.(check (list (float 0.)))
    "ends"
    [ 0.; 1.; nan; 0.; 1.; neg_infinity; infinity; 0.; nan; nan; nan ]
    (List.map Normal.cdf [ neg_infinity; infinity; nan; -1e300; 1e300 ]
    @ List.map Normal.quantile [ 0.; 1.; 0.5; -0.1; 1.5; nan ])

let suite =
  ( "normal distribution",
    [
      Candor_oracle.Law.example "probabilities agree with mpmath's within 2^-50"
        (tabled ~within:0x1p-50 Normal.cdf
           (* Tails below the normal doubles have fewer bits. *)
           (List.filter (fun (_, p) -> p > 0x1p-1022) cdfs));
      Candor_oracle.Law.example "so do tails of few bits, to an ulp or two"
        (fun () ->
          List.iter
            (fun (x, p) ->
              Alcotest.(check (float 0x1p-1070)) (show x) p (Normal.cdf x))
            (List.filter (fun (_, p) -> p <= 0x1p-1022) cdfs));
      Candor_oracle.Law.example "quantiles agree with mpmath's within 2^-50"
        (tabled ~within:0x1p-50 Normal.quantile quantiles);
      law "the probability of a quantile is what it is the quantile of" tail
        identity;
      law "quantiles are odd about 1/2 to the bit, tails add up to 1"
        Candor_oracle.Draw.(uniform 0. 1.)
        symmetric;
      rising "probabilities rise" Normal.cdf
        Candor_oracle.Draw.(uniform (-38.) 8.);
      rising "quantiles rise" Normal.quantile Candor_oracle.Draw.(uniform 0. 1.);
      Candor_oracle.Law.example "ends are infinite, what is outside is not" ends;
    ] )
