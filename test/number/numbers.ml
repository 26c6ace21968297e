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

(** [close e x y] is whether [x] is [y] within a relative [e], in doubles. *)
let close e x y = Float.equal x y || Float.abs (x -. y) <= e *. Float.abs y

(** [agree ~within name got truth] checks that, and prints both. *)
let agree ~within name got truth =
  if not (close within got truth) then
    Alcotest.failf "%s: %.17g instead of %.17g, off by %g of %g" name got truth
      (Float.abs (got -. truth) /. Float.abs truth)
      within

(** [tabled ~within f rows] checks [f] against rows of arguments and values. *)
let tabled ~within f rows () =
  List.iter (fun (x, y) -> agree ~within (Printf.sprintf "%h" x) (f x) y) rows

(** [rising name f gen] is the law that [f] never falls by more than its own
    rounding. *)
let rising name f gen =
  Law.law ~count:1000 ~print:show2 name (pair gen) (fun (a, b) ->
      let a = Float.min a b and b = Float.max a b in
      let fa = f a and fb = f b in
      fa <= fb || close 0x1p-46 fa fb)
