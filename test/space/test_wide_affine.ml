open Candor_space
open Candor_oracle
open QCheck2

let tiny = Exact.power (-100)
let get = function Some m -> m | None -> Law.fail "there is no inverse"

(* What two doubles hold of inverses, and of chains of them. *)
let wide =
  let open Gen in
  let* m = Maps.affine in
  match Wide_affine.inverse m with
  | None -> return (Wide_affine.of_affine m)
  | Some inverse ->
      let* n = Maps.affine in
      oneof
        [
          return inverse;
          return (Wide_affine.after inverse (Wide_affine.of_affine n));
        ]

(* A point and a rest below half an ulp of it. *)
let point =
  let open Gen in
  let* p = Draw.point Draw.coordinate
  and* k = Draw.vec (Draw.uniform (-1.) 1.) in
  let half x k = 0x1p-54 *. x *. k in
  return (p, Vec.v (half p.x k.x) (half p.y k.y) (half p.z k.z))

let show_wide (m : Wide_affine.t) =
  Affine.show m.high ^ " + " ^ Affine.show m.low

let show (m, (p, r)) = show_wide m ^ "\n" ^ Draw.show_point p ^ Draw.show_vec r

let images (m, ((p : Point.t), r)) =
  let at, rest = Wide_affine.point m p r in
  let along = Point.sub p Point.origin in
  let moved, rest' = Wide_affine.vector m along r in
  let exact = Exact_affine.of_wide m in
  let open Exact in
  let whole = add (point p) (vec r) in
  let size = Exact_affine.abs whole in
  let sizes = Exact_affine.absolute exact in
  Exact_affine.within tiny
    (add (point at) (vec rest))
    (Exact_affine.point exact whole)
    (Exact_affine.point sizes size)
  && Exact_affine.within tiny
       (add (vec moved) (vec rest'))
       (Exact_affine.vector exact whole)
       (Exact_affine.vector sizes size)

(* Now and then numbers are far too large, too small, or no numbers at all. *)
let odd g =
  let far =
    Draw.pick [ 0.; -0.; 0x1p-600; -0x1p-1074; 0x1p500; infinity; nan ]
  in
  Draw.either 95 g far

let ray =
  let open Gen in
  let half x k = 0x1p-54 *. x *. k in
  let rest x y z =
    let* exact = bool and* k = Draw.vec (Draw.uniform (-1.) 1.) in
    return
      (if exact then Vec.zero else Vec.v (half x k.x) (half y k.y) (half z k.z))
  in
  let* o = Draw.point (odd Draw.coordinate)
  and* d = Draw.vec (odd Draw.coordinate) in
  let* o' = rest o.x o.y o.z and* d' = rest d.x d.y d.z in
  return ((o, o'), (d, d'))

(* Of maps with large and small entries too, and with zeros of either sign. *)
let odd_map =
  Gen.oneof
    [
      wide;
      Gen.map Wide_affine.of_affine (Maps.of_entries (odd Draw.coordinate));
    ]

let show_ray ((o, o'), (d, d')) =
  Draw.show_point o ^ Draw.show_vec o' ^ " along " ^ Draw.show_vec d
  ^ Draw.show_vec d'

let same_number x y =
  (Float.is_nan x && Float.is_nan y)
  || Int64.equal (Int64.bits_of_float x) (Int64.bits_of_float y)

let same (a : Vec.t) (b : Vec.t) =
  same_number a.x b.x && same_number a.y b.y && same_number a.z b.z

let takes_rays (m, ((o, o'), (d, d'))) =
  let from (p : Point.t) = Vec.v p.x p.y p.z in
  let p, p', v, v' = Wide_affine.ray m o o' d d' in
  let q, q' = Wide_affine.point m o o' and w, w' = Wide_affine.vector m d d' in
  same (from p) (from q) && same p' q' && same v w && same v' w'

let composes (b, a) =
  let b' = Exact_affine.of_wide b and a' = Exact_affine.of_wide a in
  Exact_affine.all_within tiny
    (Exact_affine.of_wide (Wide_affine.after b a))
    (Exact_affine.after b' a')
    (Exact_affine.after (Exact_affine.absolute b') (Exact_affine.absolute a'))

let composes_exactly ((b, a), p) =
  let wide = Wide_affine.of_affine in
  let at, _ =
    Wide_affine.point (Wide_affine.after (wide b) (wide a)) p Vec.zero
  in
  Point.equal at (Affine.point b (Affine.point a p))

let is_singular m =
  Q.sign (Exact_affine.determinant (Exact_affine.of_affine m)) = 0

let inverts_exactly_when m =
  Bool.equal (Wide_affine.inverse m = None) (is_singular m)

(* Entry by entry; the translation relative to the products it is made of. *)
let inverts m =
  if is_singular m then true
  else
    let exact = Exact_affine.inverse (Exact_affine.of_affine m) in
    let sizes =
      let linear = Exact_affine.absolute exact in
      let open Exact in
      {
        linear with
        shift =
          Exact_affine.vector linear
            (Exact_affine.abs (v (q m.xt) (q m.yt) (q m.zt)));
      }
    in
    Exact_affine.all_within tiny
      (Exact_affine.of_wide (get (Wide_affine.inverse m)))
      exact sizes

let error_is_proven ((m, p), (e, (s, t, u))) =
  let found, rest = Wide_affine.point m p Vec.zero in
  let bound = Wide_affine.point_error m p e in
  let open Exact in
  let moved = add (point p) (v (q s * q e.Vec.x) (q t * q e.y) (q u * q e.z)) in
  Exact_affine.within one
    (add (point found) (vec rest))
    (Exact_affine.point (Exact_affine.of_wide m) moved)
    (vec bound)

(* G1: scales by 1e-8 and 1e8 and turns, ten times, and back. *)
let no_drift () =
  let step =
    Transform.of_steps
      [
        Scale (Vec.v 1e-8 1e-8 1e-8);
        Rotate { axis = Vec.v 1. 2. 3.; degrees = 31. };
        Scale (Vec.v 1e8 1e8 1e8);
        Translate (Vec.v 0.1 0.2 0.3);
      ]
  in
  match step with
  | Error why -> Alcotest.fail why
  | Ok step ->
      let rec chain n =
        if n = 1 then step else Transform.after step (chain (n - 1))
      in
      let m = chain 10 in
      let there, rest =
        Wide_affine.point (Transform.forward m) (Point.v 1. 0.7 0.3) Vec.zero
      in
      let back, rest = Wide_affine.point (Transform.backward m) there rest in
      let off = Vec.add (Point.sub back (Point.v 1. 0.7 0.3)) rest in
      if Vec.largest off > 0x1p-95 then
        Alcotest.failf "off by %h" (Vec.largest off)

let law ?(count = 5000) name gen print holds =
  Law.law ~count ~print name gen holds

let unit = Draw.pick [ -1.; 0.; 1.; 0.5 ]

let suite =
  ( "wide affine maps",
    [
      law "images are within 2^-100" (Gen.pair wide point) show images;
      law ~count:20000
        "rays go where their origins and directions go, bit for bit"
        (Gen.pair odd_map ray)
        (fun (m, r) -> show_wide m ^ "\n" ^ show_ray r)
        takes_rays;
      law "compositions are within 2^-100" (Gen.pair wide wide)
        (fun (b, a) -> show_wide b ^ "\n" ^ show_wide a)
        composes;
      law "whole maps compose exactly"
        (Gen.pair (Gen.pair Maps.whole Maps.whole) (Draw.point (Draw.small 9)))
        (fun ((b, a), p) ->
          String.concat "\n" [ Affine.show b; Affine.show a; Point.show p ])
        composes_exactly;
      law "G2: whole maps have an inverse iff their determinant is not 0"
        Maps.whole Affine.show inverts_exactly_when;
      law "G2: maps of three columns in a plane have no inverse" Maps.singular
        Affine.show inverts_exactly_when;
      law "each entry of an inverse is within 2^-100" Maps.affine Affine.show
        inverts;
      law "the error of an image is as proven"
        (Gen.pair
           (Gen.pair wide (Draw.point Draw.coordinate))
           (Gen.pair
              (Draw.vec (Gen.oneof [ Gen.return 0.; Draw.wide (-20.) 0. ]))
              (Gen.triple unit unit unit)))
        (fun ((m, p), (e, _)) ->
          String.concat "\n" [ show_wide m; Draw.show_point p; Draw.show_vec e ])
        error_is_proven;
      Law.example "G1: ten nested scales and turns do not drift" no_drift;
    ] )
