open Candor_space
open Candor_oracle
open QCheck2

let print ((p, a), t) =
  Printf.sprintf "%s %s %h" (Draw.show_point p) (Draw.show_vec a) t

let case =
  Gen.pair
    (Gen.pair (Draw.point Draw.coordinate) (Draw.vec Draw.coordinate))
    Draw.coordinate

let rounded_once ((p, d), t) =
  let q = Point.along p d t in
  let exact = Exact.along (Exact.point p) (Exact.vec d) (Exact.q t) in
  let same x y = Float.equal x (Q.to_float y) in
  same q.x exact.x && same q.y exact.y && same q.z exact.z

let there_and_back ((p, a), _) =
  let q = Point.add p a in
  Vec.equal (Point.sub q p) (Vec.neg (Point.sub p q))
  && Point.equal (Point.add p Vec.zero) p

let coordinates ((p, _), _) =
  Float.equal (Point.get p 0) p.Point.x
  && Float.equal (Point.get p 1) p.y
  && Float.equal (Point.get p 2) p.z

let shifted ((p, _), t) =
  let e = int_of_float (Float.rem t 900.) in
  let q = Point.ldexp e p in
  let same x y = Float.equal x (Q.to_float Exact.(power e * q y)) in
  same q.x p.Point.x && same q.y p.y && same q.z p.z

let finite () =
  List.iter
    (fun x ->
      Alcotest.(check bool) "no" false (Point.is_finite (Point.v 0. 0. x)))
    [ nan; infinity; neg_infinity ];
  Alcotest.(check bool) "yes" true (Point.is_finite (Point.v 0. 0. max_float))

let law name holds = Law.law ~count:5000 ~print name case holds

let suite =
  ( "points",
    [
      law "a point along a direction is rounded once" rounded_once;
      law "the way back is the way there turned round" there_and_back;
      law "get is the coordinate" coordinates;
      law "ldexp multiplies by a power of two" shifted;
      Law.example "infinities and nan are not finite" finite;
    ] )
