(** Numbers to compute with, and words to compare results in. *)

open Candor_number
open Candor_oracle
open QCheck2

(** Any size whose products stay in range. *)
let real =
  Gen.oneof
    [
      Draw.coordinate;
      Draw.signed (Draw.wide (-60.) 60.);
      Draw.nudged (Draw.signed (Draw.power (-200) 200));
      Draw.uniform (-2.) 2.;
    ]

(* No error of a product may fall below 2^-1074. *)
let in_range x = if Float.abs x < 0x1p-260 then 0. *. x else x
let real = Gen.map in_range real
let pair g = Gen.pair g g
let show2 (a, b) = Printf.sprintf "%h %h" a b
let quadruple g = Gen.quad g g g g
let show4 (a, b, c, d) = Printf.sprintf "%h %h %h %h" a b c d

(** [exactly s] is the value of the unevaluated sum [s]. *)
let exactly { Error_free.hi; lo } = Exact.(q hi + q lo)

(** [relative x y] is whether |x − y| ≤ e |y|. *)
let relative e x y = Q.leq (Q.abs (Q.sub x y)) (Q.mul e (Q.abs y))
