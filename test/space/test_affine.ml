open Candor_space
open Candor_oracle
open QCheck2

let show (m, p) = Affine.show m ^ "\n" ^ Draw.show_point p
let case = Gen.pair Maps.affine (Draw.point Draw.coordinate)

let image (m : Affine.t) (p : Exact.vec) =
  let a, b, c = Maps.rows m in
  Exact.(v (dot a p + q m.xt) (dot b p + q m.yt) (dot c p + q m.zt))

let is_within (off : Exact.vec) (e : Vec.t) =
  let ok x e = Q.leq (Q.abs x) (Exact.q e) in
  ok off.x e.x && ok off.y e.y && ok off.z e.z

(* A point off by at most e goes to one off by at most the error given. *)
let error_is_proven ((m, p), (e, (s, t, u))) =
  let found = Exact.point (Affine.point m p) in
  let bound = Vec.add (Affine.point_error m p) (Affine.spread m e) in
  let open Exact in
  let true_p =
    add (point p) (v (q s * q e.Vec.x) (q t * q e.y) (q u * q e.z))
  in
  is_within (sub found (image m true_p)) bound

let vectors_and_points (m, p) =
  let o = Affine.point m Point.origin in
  let direct = Affine.vector m (Point.sub p Point.origin) in
  Point.equal o (Point.v m.Affine.xt m.yt m.zt)
  && Vec.equal
       (Affine.vector
          { m with xt = 7.; yt = -7.; zt = 0.5 }
          (Point.sub p Point.origin))
       direct

let transposes (m, p) =
  let a = Point.sub p Point.origin in
  let t =
    {
      m with
      Affine.xy = m.Affine.yx;
      yx = m.xy;
      xz = m.zx;
      zx = m.xz;
      yz = m.zy;
      zy = m.yz;
    }
  in
  Vec.equal (Affine.transposed m a) (Affine.vector t a)

let by_columns m =
  Affine.equal m (Affine.of_columns (Affine.columns m))
  && Vec.equal (Affine.columns m).y (Affine.vector m (Vec.v 0. 1. 0.))

let law ?(count = 10000) name gen print holds =
  Law.law ~count ~print name gen holds

let unit = Draw.pick [ -1.; 0.; 1.; 0.5 ]

let suite =
  ( "affine maps",
    [
      law "the error of an image is as proven"
        (Gen.pair case
           (Gen.pair
              (Draw.vec (Gen.oneof [ Gen.return 0.; Draw.wide (-20.) 0. ]))
              (Gen.triple unit unit unit)))
        (fun (c, (e, _)) -> show c ^ "\n" ^ Draw.show_vec e)
        error_is_proven;
      law "vectors leave the translation out" case show vectors_and_points;
      law "transposed is by the transpose" case show transposes;
      law "a map is its columns" Maps.whole Affine.show by_columns;
    ] )
