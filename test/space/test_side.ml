open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2

let both = [ Side.Outside; Inside ]
let side = Alcotest.testable Side.pp Side.equal

let opposites () =
  Alcotest.check side "of outside" Side.Inside (Side.opposite Outside);
  Alcotest.check side "of inside" Side.Outside (Side.opposite Inside)

let derived () =
  List.iteri
    (fun i a ->
      List.iteri
        (fun j b ->
          Alcotest.(check bool) "equal" (i = j) (Side.equal a b);
          Alcotest.(check int) "order" (Int.compare i j) (Side.compare a b))
        both)
    both;
  Alcotest.(check (list string))
    "shown"
    [ "Side.Outside"; "Side.Inside" ]
    (List.map Side.show both)

(* {1 Which side is which}

   The side that a ray comes from is the one its origin is on, if there is only
   one surface of a convex body ahead. *)

let valid = function Ok x -> x | Error why -> Alcotest.fail why

let sphere =
  Surface.sphere (valid (Sphere.make ~center:Point.origin ~radius:3.)) ()

let box =
  let corner = Point.v 3. 3. 3. in
  Surface.box (valid (Box.make ~min:(Point.v (-3.) (-3.) (-3.)) ~max:corner)) ()

let in_sphere (p : Point.t) = (p.x *. p.x) +. (p.y *. p.y) +. (p.z *. p.z) -. 9.

let in_box (p : Point.t) =
  List.fold_left (fun m c -> Float.max m (Float.abs c)) 0. [ p.x; p.y; p.z ]
  -. 3.

let met surface ray expected =
  match Surface.nearest surface ray with
  | None -> true
  | Some hit -> Side.equal hit.Hit.side expected

(* Whole numbers, on which F is exact. *)
let ray =
  let whole = Draw.small 6 in
  Gen.pair (Draw.point whole) (Draw.point whole)

let ray_of (o, p) = Ray.v o (Point.sub p o)
let print drawn = Draw.show_ray (ray_of drawn)

let positive_outside name surface f =
  Law.law ~print
    (Printf.sprintf "F is positive outside of a %s, and negative inside" name)
    ray (fun (o, p) ->
      let f = f o in
      f = 0.
      || met surface (ray_of (o, p)) (if f > 0. then Side.Outside else Inside))

let corners =
  Gen.triple
    (Draw.point (Draw.small 4))
    (Draw.point (Draw.small 4))
    (Draw.point (Draw.small 4))

(* Seen from outside the corners run counter-clockwise. *)
let triangle =
  let print ((a, b, c), o) =
    String.concat " " (List.map Draw.show_point [ a; b; c; o ])
  in
  Law.law ~print "from outside of a triangle its corners run counter-clockwise"
    (Gen.pair corners (Draw.point (Draw.small 6)))
    (fun ((a, b, c), o) ->
      match Triangle.make { a; b; c } with
      | Error _ -> true
      | Ok t -> (
          let normal = Vec.cross (Point.sub b a) (Point.sub c a) in
          let above = Vec.dot normal (Point.sub o a) in
          let third = 1. /. 3. in
          let middle =
            Point.add a
              (Vec.scale third (Vec.add (Point.sub b a) (Point.sub c a)))
          in
          let ray = Ray.v o (Point.sub middle o) in
          match Surface.nearest (Surface.triangle t ()) ray with
          | None -> above = 0.
          | Some hit ->
              Side.equal hit.side (if above > 0. then Outside else Inside)))

let suite =
  ( "sides",
    [
      Law.example "the sides are each other's opposite" opposites;
      Law.example "there are two sides, outside before inside" derived;
      positive_outside "sphere" sphere in_sphere;
      positive_outside "box" box in_box;
      triangle;
    ] )
