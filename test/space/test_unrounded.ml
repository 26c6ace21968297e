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

let near_one (a : Vec.t) =
  let { Double_double.x; y; z }, e = Unrounded.pair_near_one a in
  let m = Vec.largest (Vec.v x.hi y.hi z.hi) in
  let back (x : Double_double.t) = Float.ldexp x.hi e in
  Vec.equal a Vec.zero
  || (0.5 <= m && m < 1. && Vec.equal a (Vec.v (back x) (back y) (back z)))

let suite =
  let number = Draw.wide (-40.) 40. in
  let signed = Gen.(oneof [ Draw.small 9; number; map Float.neg number ]) in
  let point = Draw.point signed in
  ( "unrounded vectors",
    [
      Law.law
        ~print:(fun (p, o) -> Point.show p ^ "\n" ^ Point.show o)
        "a difference of points loses nothing" (Gen.pair point point) difference;
      Law.law ~print:Vec.show "a power of two brings a vector near one"
        (Draw.vec signed) near_one;
    ] )
