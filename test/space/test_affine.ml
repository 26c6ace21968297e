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
  let bound = Affine.point_error m p e in
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

(* Whole numbers round nothing. *)
let whole = Maps.of_entries (Draw.small 9)

let composes ((b, a), p) =
  Point.equal
    (Affine.point (Affine.after b a) p)
    (Affine.point b (Affine.point a p))

let determinants m =
  Exact.q (Affine.determinant m) |> Q.equal (Maps.determinant m)

let is_singular m = Q.sign (Maps.determinant m) = 0

let inverts_exactly_when m =
  Bool.equal (Affine.inverse m = None) (is_singular m)

(* The last column is a sum of multiples of the others, exactly. *)
let singular =
  let open Gen in
  let number = Draw.uniform (-3.) 3. in
  let* m = Maps.of_entries (map (Draw.rounded 26) number) in
  let* j = Draw.small 3 and* k = Draw.small 3 in
  return
    {
      m with
      Affine.xz = (j *. m.xx) +. (k *. m.xy);
      yz = (j *. m.yx) +. (k *. m.yy);
      zz = (j *. m.zx) +. (k *. m.zy);
    }

let undone (m, p) =
  match Affine.inverse m with
  | None -> is_singular m
  | Some back ->
      let size (a : Affine.t) =
        List.fold_left
          (fun x y -> Float.max x (Float.abs y))
          0.
          [ a.xx; a.xy; a.xz; a.yx; a.yy; a.yz; a.zx; a.zy; a.zz ]
      in
      let condition = 9. *. size m *. size back in
      let q = Affine.point back (Affine.point m p) in
      let off = Vec.largest (Point.sub q p) in
      let reach =
        Vec.largest (Point.sub p Point.origin)
        +. Float.abs m.xt +. Float.abs m.yt +. Float.abs m.zt
      in
      off <= 0x1p-48 *. condition *. (1. +. size back) *. (1. +. reach)

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
      law "whole maps compose exactly"
        (Gen.pair (Gen.pair whole whole) (Draw.point (Draw.small 9)))
        (fun ((b, a), p) -> Affine.show b ^ show (a, p))
        composes;
      law "the determinant of whole maps is exact" whole Affine.show
        determinants;
      law "whole maps have an inverse iff their determinant is not 0" whole
        Affine.show inverts_exactly_when;
      law "maps of three columns in a plane have no inverse" singular
        Affine.show inverts_exactly_when;
      law "the inverse undoes" case show undone;
    ] )
