open Candor_number
open Candor_space
open Candor_oracle
open QCheck2

let exact { Error_free.hi; lo } = Exact.(q hi + q lo)

let difference ((p : Point.t), (o : Point.t)) =
  let { Double_double.x; y; z } = Unrounded.pair_diff p o in
  let e = Unrounded.diff p o in
  let is a b pair (sum : Expansion.t) =
    let truth = Exact.(q a - q b) in
    Q.equal (exact pair) truth && Expansion.sign sum = Q.sign truth
  in
  is p.x o.x x e.x && is p.y o.y y e.y && is p.z o.z z e.z

let lost (p, o) =
  let d = Point.sub p o in
  let e = Unrounded.diff_error p o d in
  let open Exact in
  let whole = add (vec d) (vec e) and truth = sub (point p) (point o) in
  Q.equal whole.x truth.x && Q.equal whole.y truth.y && Q.equal whole.z truth.z

let suite =
  let number = Draw.wide (-40.) 40. in
  let signed = Gen.(oneof [ Draw.small 9; number; map Float.neg number ]) in
  let point = Draw.point signed in
  let law name holds =
    Law.law
      ~print:(fun (p, o) -> Point.show p ^ "\n" ^ Point.show o)
      name (Gen.pair point point) holds
  in
  ( "unrounded vectors",
    [
      law "a difference of points loses nothing" difference;
      law "what a rounded difference lost is exact" lost;
    ] )
