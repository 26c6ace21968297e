open Candor_number
open Candor_oracle
open QCheck2

let same x y = Int64.equal (Int64.bits_of_float x) (Int64.bits_of_float y)

let next x =
  same (Neighbour.succ x) (Float.succ x)
  && same (Neighbour.pred x) (Float.pred x)

(* Powers of two and what is around them, of every size, are where steps
   change. *)
let around =
  let open Gen in
  let* e = int_range (-1080) 1023 and* bits = int_bound 3 and* up = bool in
  let x = Float.ldexp 1. e in
  let step x = if up then Float.succ x else Float.pred x in
  let rec go n x = if n = 0 then x else go (n - 1) (step x) in
  map (fun minus -> if minus then -.go bits x else go bits x) bool

let any = Gen.map Int64.float_of_bits Gen.int64

let corners () =
  List.iter
    (fun x -> Alcotest.(check bool) (Printf.sprintf "%h" x) true (next x))
    [ 0.; -0.; 5e-324; -5e-324; 1.; -1.; max_float; -.max_float; infinity ];
  Alcotest.(check bool) "-inf" true (next neg_infinity);
  Alcotest.(check bool) "nan" true (Float.is_nan (Neighbour.succ nan))

(* A nan has many bits. *)
let next_of_number x = Float.is_nan x || next x

let law name gen f =
  Law.law ~count:20000 ~print:(Printf.sprintf "%h") name gen f

let suite =
  ( "neighbours",
    [
      law "next to any double are those of Float" any next_of_number;
      law "next to powers of two, too" around next;
      Law.example "and next to the first and the last" corners;
    ] )
