open Candor_space
open Candor_oracle
open QCheck2

let box =
  let open Gen in
  let corner = Draw.point (oneof [ Draw.small 3; Draw.any_coordinate ]) in
  let* a = corner and* b = corner in
  Draw.either 10 (return Bounds.empty) (return (Bounds.of_points [ a; b ]))

let point = Draw.point (Gen.oneof [ Draw.small 3; Draw.any_coordinate ])
let show = Bounds.show
let show3 (a, b, p) = String.concat "\n" [ show a; show b; Draw.show_point p ]

let joins (a, b, p) =
  let j = Bounds.join a b in
  ((not (Bounds.mem p a || Bounds.mem p b)) || Bounds.mem p j)
  && Bounds.equal j (Bounds.join b a)
  && Bounds.equal (Bounds.join a Bounds.empty) a
  && Bounds.equal (Bounds.join Bounds.empty a) a
  && Bounds.equal (Bounds.join a a) a

let meets (a, b, p) =
  Bool.equal (Bounds.mem p (Bounds.meet a b)) (Bounds.mem p a && Bounds.mem p b)
  && Bounds.equal (Bounds.meet a Bounds.everything) a

let widened ((a, _, p), e) =
  let w = Bounds.widen e a in
  (not (Bounds.mem p a))
  || List.for_all
       (fun (x, y, z) ->
         let open Exact in
         let r = point p in
         let r =
           v (r.x + (q x * q e)) (r.y + (q y * q e)) (r.z + (q z * q e))
         in
         Q.leq (q w.x0) r.x
         && Q.geq (q w.x1) r.x
         && Q.leq (q w.y0) r.y
         && Q.geq (q w.y1) r.y
         && Q.leq (q w.z0) r.z
         && Q.geq (q w.z1) r.z)
       [ (1., 1., 1.); (-1., -1., -1.); (1., -1., 0.) ]

let of_points ps =
  let b = Bounds.of_points ps in
  List.for_all (fun p -> Bounds.mem p b) ps
  && List.for_all
       (fun i ->
         List.exists (fun p -> Point.get p i = Point.get (Bounds.low b) i) ps
         && List.exists
              (fun p -> Point.get p i = Point.get (Bounds.high b) i)
              ps)
       [ 0; 1; 2 ]

(* The exact image of a point of the box is in the image of the box. *)
let transformed ((a, b), (m, (s, t, u))) =
  let box = Bounds.of_points [ a; b ] in
  let image = Bounds.transform (Wide_affine.of_affine m) box in
  let between lo hi k = Exact.(q lo + (q k * (q hi - q lo))) in
  let open Exact in
  let x = between box.x0 box.x1 s
  and y = between box.y0 box.y1 t
  and z = between box.z0 box.z1 u in
  let row a b c d = (q a * x) + (q b * y) + (q c * z) + q d in
  let x' = row m.Affine.xx m.xy m.xz m.xt
  and y' = row m.yx m.yy m.yz m.yt
  and z' = row m.zx m.zy m.zz m.zt in
  Q.leq (q image.x0) x'
  && Q.geq (q image.x1) x'
  && Q.leq (q image.y0) y'
  && Q.geq (q image.y1) y'
  && Q.leq (q image.z0) z'
  && Q.geq (q image.z1) z'

let empties () =
  let m = Wide_affine.of_affine { Affine.identity with xx = 2.; xt = 1. } in
  let is_empty (b : Bounds.t) = b.x0 > b.x1 in
  Alcotest.(check bool)
    "empty stays empty" true
    (is_empty (Bounds.transform m Bounds.empty));
  Alcotest.(check bool)
    "everything stays so" true
    (Bounds.equal Bounds.everything (Bounds.transform m Bounds.everything));
  Alcotest.(check bool)
    "empty is not finite" false
    (Bounds.is_finite Bounds.empty);
  let half = Bounds.v (Point.v 0. 0. 0.) (Point.v infinity 1. 1.) in
  Alcotest.(check bool)
    "half-open stays unbounded" false
    (Bounds.is_finite (Bounds.transform m half))

let three = Gen.triple box box point

let law ?(count = 10000) name gen print holds =
  Law.law ~count ~print name gen holds

let unit = Gen.oneof [ Draw.pick [ 0.; 1. ]; Draw.uniform 0. 1. ]

let suite =
  ( "bounds",
    [
      law "joining is the least box that holds both" three show3 joins;
      law "meeting is what both hold" three show3 meets;
      law "widening is rounded outwards"
        (Gen.pair three
           (Gen.oneof [ Draw.pick [ 0.; 5e-324 ]; Draw.wide (-20.) 8. ]))
        (fun (x, e) -> Printf.sprintf "%s\n%h" (show3 x) e)
        widened;
      law "the box of points is the least"
        (Gen.list_size (Gen.int_range 1 9) point)
        (fun ps -> String.concat " " (List.map Draw.show_point ps))
        of_points;
      law "the image of a box holds the image of its points"
        (Gen.pair
           (Gen.pair (Draw.point Draw.coordinate) (Draw.point Draw.coordinate))
           (Gen.pair Maps.affine (Gen.triple unit unit unit)))
        (fun ((a, b), (m, _)) ->
          String.concat "\n"
            [ Draw.show_point a; Draw.show_point b; Affine.show m ])
        transformed;
      Law.example "empty and unbounded boxes stay so" empties;
    ] )
