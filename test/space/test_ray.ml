open Candor_space
open Candor_oracle
open QCheck2

let starts_nowhere (r : Ray.t) =
  let again = Ray.v r.origin r.direction in
  again.departure = Ray.Nowhere
  && Point.equal (Ray.at again 0.) r.origin
  && Point.equal (Ray.at again 2.) (Point.along r.origin r.direction 2.)

let somewhere = Ray.Surface { path = [ 3; 0; 7 ]; part = 2; side = Inside }

let leaves_as_told (r : Ray.t) =
  let again = Ray.leaving somewhere r.origin r.direction in
  Ray.equal_departure again.departure somewhere
  && Ray.equal r (Ray.leaving Nowhere r.origin r.direction)
  && Point.equal again.origin r.origin
  && Vec.equal again.direction r.direction
  && Vec.equal again.direction_low Vec.zero

(* origin + direction + direction_low = p, in rationals; and the low part is what
   rounding took, no more. *)
let arrives ((r : Ray.t), p) =
  let there = Ray.toward p r in
  let low = there.direction_low in
  let half_ulp x e = Q.leq Exact.(two * Q.abs (q e)) (Exact.q (Exact.ulp x)) in
  let arrived =
    Exact.(
      sub
        (add (point there.origin)
           (add (vec there.direction) (vec there.direction_low)))
        (point p))
  in
  Q.sign (Exact.size arrived) = 0
  && Point.equal there.origin r.origin
  && Ray.equal_departure there.departure r.departure
  && half_ulp there.direction.x low.x
  && half_ulp there.direction.y low.y
  && half_ulp there.direction.z low.z

let leaving =
  Gen.map2
    (fun (r : Ray.t) leaves ->
      if leaves then Ray.leaving somewhere r.origin r.direction else r)
    Draw.ray Gen.bool

let sides () =
  List.iter
    (fun s ->
      Alcotest.(check bool)
        "twice is once" true
        (Side.opposite (Side.opposite s) = s && Side.opposite s <> s))
    [ Side.Outside; Inside ]

let suite =
  ( "rays",
    [
      Law.law ~print:Draw.show_ray "a ray starts nowhere, at its origin"
        Draw.ray starts_nowhere;
      Law.law ~print:Draw.show_ray "a ray that leaves a surface says which"
        Draw.ray leaves_as_told;
      Law.law ~count:5000
        ~print:(fun (r, p) -> Draw.show_ray r ^ " toward " ^ Draw.show_point p)
        "a ray toward a point is exactly there at t = 1"
        (Gen.pair leaving (Draw.point Draw.coordinate))
        arrives;
      Law.example "there are two sides" sides;
    ] )
