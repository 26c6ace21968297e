open Candor_number
open Candor_oracle
open QCheck2
module E = Expansion

(* A formula, to be evaluated both ways. *)
type formula =
  | Number of float
  | Sum of formula * formula
  | Difference of formula * formula
  | Product of formula * formula
  | Opposite of formula
  | Shifted of int * formula

let rec show = function
  | Number x -> Printf.sprintf "%h" x
  | Sum (a, b) -> Printf.sprintf "(%s + %s)" (show a) (show b)
  | Difference (a, b) -> Printf.sprintf "(%s - %s)" (show a) (show b)
  | Product (a, b) -> Printf.sprintf "(%s * %s)" (show a) (show b)
  | Opposite a -> Printf.sprintf "-%s" (show a)
  | Shifted (k, a) -> Printf.sprintf "2^%d %s" k (show a)

let number =
  Gen.map Numbers.in_range
  @@ Gen.oneof
       [
         Draw.small 9;
         Draw.uniform (-3.) 3.;
         Draw.signed (Draw.wide (-8.) 8.);
         Draw.signed (Draw.power (-60) 60);
         Draw.nudged (Draw.small 3);
       ]

(* Half of the differences are of a formula and almost itself. *)
let rec formula depth =
  let open Gen in
  let leaf = map (fun x -> Number x) number in
  if depth = 0 then leaf
  else
    let below = formula (depth - 1) in
    let pair f = map2 f below below in
    oneof
      [
        leaf;
        pair (fun a b -> Sum (a, b));
        pair (fun a b -> Difference (a, b));
        pair (fun a b -> Product (a, b));
        pair (fun a b -> Product (a, b));
        pair (fun a b -> Difference (Product (a, b), Product (b, a)));
        map (fun a -> Opposite a) below;
        map2 (fun k a -> Shifted (k, a)) (int_range (-20) 20) below;
      ]

let rec expansion = function
  | Number x -> E.of_float x
  | Sum (a, b) -> E.add (expansion a) (expansion b)
  | Difference (Number a, Number b) -> E.diff a b
  | Difference (a, b) -> E.sub (expansion a) (expansion b)
  | Product (a, b) -> E.mul (expansion a) (expansion b)
  | Opposite a -> E.neg (expansion a)
  | Shifted (k, a) -> E.shift k (expansion a)

let rec truth = function
  | Number x -> Exact.q x
  | Sum (a, b) -> Q.add (truth a) (truth b)
  | Difference (a, b) -> Q.sub (truth a) (truth b)
  | Product (a, b) -> Q.mul (truth a) (truth b)
  | Opposite a -> Q.neg (truth a)
  | Shifted (k, a) -> Q.mul (Exact.power k) (truth a)

let agrees f =
  let x = expansion f and y = truth f in
  E.sign x = Q.sign y && Exact.within 1. (E.to_float x) y

let ratio (f, g) =
  let x = truth f and y = truth g in
  Q.sign y = 0
  || Exact.within 2. (E.ratio (expansion f) (expansion g)) (Q.div x y)

(* Determinants of whole numbers, a third of them zero. *)
let rows =
  let open Gen in
  let row = Draw.vec (Draw.small 1000000) in
  let* a = row and* b = row and* c = row and* k = int_bound 2 in
  let open Candor_space.Vec in
  return (a, b, if k = 0 then add (scale 3. a) (scale (-7.) b) else c)

let expansion_vec (a : Candor_space.Vec.t) =
  { E.x = E.of_float a.x; y = E.of_float a.y; z = E.of_float a.z }

let triple (a, b, c) =
  let det =
    E.(dot (expansion_vec a) (cross (expansion_vec b) (expansion_vec c)))
  in
  let truth = Exact.(dot (vec a) (cross (vec b) (vec c))) in
  E.sign det = Q.sign truth && Exact.within 1. (E.to_float det) truth

let show_rows (a, b, c) = String.concat " " (List.map Draw.show_vec [ a; b; c ])

let zero () =
  let third = E.sub (E.of_float 0.1) (E.of_float 0.1) in
  Alcotest.(check int) "its sign" 0 (E.sign third);
  Alcotest.(check (float 0.)) "its value" 0. (E.to_float third);
  Alcotest.(check bool)
    "over zero is no number" true
    (not (Float.is_finite (E.ratio (E.of_float 1.) third)))

let pairs f =
  let x = truth f in
  let { Error_free.hi; lo } = E.to_pair (expansion f) in
  Q.leq (Q.abs Exact.(q hi + q lo - x)) Exact.(power (-104) * Q.abs x)

let suite =
  ( "expansions",
    [
      Law.law ~count:20000 ~print:show
        "sums, products, signs and roundings agree with rationals" (formula 4)
        agrees;
      Law.law ~count:10000
        ~print:(fun (f, g) -> show f ^ " / " ^ show g)
        "a ratio is right within two ulps"
        (Gen.pair (formula 3) (formula 3))
        ratio;
      Law.law ~count:10000 ~print:show_rows
        "the signs of determinants agree with rationals" rows triple;
      Law.law ~count:10000 ~print:show "a pair is right within 2^-104"
        (formula 3) pairs;
      Law.example "zero is the empty sum" zero;
    ] )
