open Candor_space
open Candor_oracle
open QCheck2

let steps = Gen.list_size (Gen.int_range 0 6) Maps.step
let show (s, p) = Maps.show_steps s ^ "\n" ^ Draw.show_point p

let get s =
  match Transform.of_steps s with Ok m -> m | Error e -> Law.fail "%s" e

let image m p = fst (Wide_affine.point m p Vec.zero)
let near (p : Point.t) (q : Point.t) e = Vec.largest (Point.sub p q) <= e

(* Large enough for any point that six steps can make of this one. *)
let reach s p =
  List.fold_left
    (fun r step ->
      match step with
      | Transform.Translate v -> r +. Vec.norm v
      | Scale v -> r *. Float.max 1. (Vec.largest v)
      | Rotate _ | Matrix _ -> r)
    (Vec.norm (Point.sub p Point.origin))
    s

let least s =
  List.fold_left
    (fun k step ->
      match step with
      | Transform.Scale v ->
          let m =
            Float.min (Float.abs v.x)
              (Float.min (Float.abs v.y) (Float.abs v.z))
          in
          k *. Float.min 1. m
      | Translate _ | Rotate _ | Matrix _ -> k)
    1. s

let undoes (s, p) =
  let m = get s in
  let there = image (Transform.forward m) p in
  let back = image (Transform.backward m) there in
  near back p (0x1p-44 *. reach s p /. least s)

let in_order (s, p) =
  let one step p = image (Transform.forward (get [ step ])) p in
  let by_steps = List.fold_left (fun p step -> one step p) p s in
  let at_once = image (Transform.forward (get s)) p in
  near by_steps at_once (0x1p-46 *. reach s p)

let composes ((a, b), p) =
  let both = Transform.after (get b) (get a) and listed = get (a @ b) in
  near
    (image (Transform.forward both) p)
    (image (Transform.forward listed) p)
    (0x1p-46 *. reach (a @ b) p)

let turns (p, k) =
  (* Quarter turns about the axes are exact permutations. *)
  let turn axis p =
    image (Transform.forward (get [ Rotate { axis; degrees = 90. *. k } ])) p
  in
  let by_z = turn (Vec.v 0. 0. 2.) p in
  let { Point.x; y; z } = p in
  let expected =
    match ((int_of_float k mod 4) + 4) mod 4 with
    | 0 -> Point.v x y z
    | 1 -> Point.v (-.y) x z
    | 2 -> Point.v (-.x) (-.y) z
    | _ -> Point.v y (-.x) z
  in
  Point.equal by_z expected

let keeps_lengths ((axis, degrees), p) =
  let m = get [ Rotate { axis; degrees } ] in
  let a = Point.sub p Point.origin in
  let b, _ = Wide_affine.vector (Transform.forward m) a Vec.zero in
  Float.abs (Vec.norm b -. Vec.norm a) <= 0x1p-49 *. Vec.norm a

let identity () =
  let p = Point.v 0.1 0.2 0.3 in
  let same m = Point.equal p (image (Transform.forward m) p) in
  Alcotest.(check bool) "identity" true (same Transform.identity);
  Alcotest.(check bool) "no steps" true (same (get []))

let seen_against_the_axis () =
  let m = get [ Rotate { axis = Vec.v 0. 1. 0.; degrees = 90. } ] in
  let q = image (Transform.forward m) (Point.v 0. 0. 1.) in
  Alcotest.(check bool)
    "z goes to x about y" true
    (Point.equal q (Point.v 1. 0. 0.))

let rejected =
  let reject name s =
    Law.example (name ^ " is rejected") (fun () ->
        match Transform.of_steps s with
        | Error why when why <> "" -> ()
        | _ -> Alcotest.failf "%s is accepted" name)
  in
  let m = Affine.identity in
  [
    reject "G2: a scale by zero on an axis" [ Scale (Vec.v 1. 1. 0.) ];
    reject "a scale by minus zero" [ Scale (Vec.v 1. (-0.) 1.) ];
    reject "a scale by nan" [ Scale (Vec.v nan 1. 1.) ];
    reject "a scale by infinity" [ Scale (Vec.v infinity 1. 1.) ];
    reject "a translation by nan" [ Translate (Vec.v nan 1. 1.) ];
    reject "a translation to infinity" [ Translate (Vec.v 0. infinity 1.) ];
    reject "a rotation about nothing"
      [ Rotate { axis = Vec.zero; degrees = 9. } ];
    reject "a rotation about nan"
      [ Rotate { axis = Vec.v nan 0. 1.; degrees = 9. } ];
    reject "a rotation by nan"
      [ Rotate { axis = Vec.v 0. 0. 1.; degrees = nan } ];
    reject "a rotation by infinity"
      [ Rotate { axis = Vec.v 0. 0. 1.; degrees = infinity } ];
    reject "G2: a matrix of rank 2" [ Matrix { m with zz = 0. } ];
    reject "a matrix of rank 2 that rounds"
      [
        Matrix
          {
            m with
            xx = 0.1;
            xy = 0.2;
            xz = 0.1 *. 3.;
            yx = 0.1;
            yy = 0.2;
            yz = 0.1 *. 3.;
          };
      ];
    reject "a matrix with a nan" [ Matrix { m with xy = nan } ];
    reject "a matrix with an infinity" [ Matrix { m with xt = infinity } ];
    reject "scales that overflow together"
      [ Scale (Vec.v 1e300 1. 1.); Scale (Vec.v 1e300 1. 1.) ];
    reject "scales that underflow together"
      [ Scale (Vec.v 1e-300 1. 1.); Scale (Vec.v 1e-300 1. 1.) ];
  ]

let accepted () =
  let m = Affine.identity in
  List.iter
    (fun s ->
      Alcotest.(check bool)
        (Maps.show_steps s) true
        (Result.is_ok (Transform.of_steps s)))
    [
      [ Transform.Scale (Vec.v 1e-110 1e-110 1e-110) ];
      [ Scale (Vec.v 1e110 1e110 1e-110) ];
      [ Matrix { m with xx = 1e-110; yy = 1e-110; zz = 1e-110 } ];
      [ Matrix { m with xx = 1e150; yy = -1e150; zz = 1e150 } ];
      [ Matrix { m with xx = 1.; xy = 1.; yx = 1.; yy = Float.succ 1. } ];
      [ Scale (Vec.v (-1.) 1. 1.) ];
    ]

let law ?(count = 5000) name gen print holds =
  Law.law ~count ~print name gen holds

let place = Draw.point (Draw.uniform (-9.) 9.)

let suite =
  ( "transforms",
    List.append
      [
        law "backward undoes forward" (Gen.pair steps place) show undoes;
        law "the first step acts first" (Gen.pair steps place) show in_order;
        law "after is one list of steps after the other"
          (Gen.pair (Gen.pair steps steps) place)
          (fun ((a, b), p) -> Maps.show_steps a ^ " then " ^ show (b, p))
          composes;
        law "quarter turns are exact"
          (Gen.pair place (Draw.small 9))
          (fun (p, k) -> Printf.sprintf "%s %g" (Draw.show_point p) k)
          turns;
        law "rotations keep lengths"
          (Gen.pair (Gen.pair Draw.unit (Draw.uniform (-720.) 720.)) place)
          (fun ((a, d), p) ->
            Printf.sprintf "%s %h %s" (Draw.show_vec a) d (Draw.show_point p))
          keeps_lengths;
        Law.example "the identity changes nothing" identity;
        Law.example "rotations are counter-clockwise against the axis"
          seen_against_the_axis;
        Law.example "G2: small and large maps are not singular" accepted;
      ]
      rejected )
