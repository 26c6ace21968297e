open Candor_number

type t = { high : Affine.t; low : Affine.t }

let of_affine high = { high; low = Affine.zero }

(* {1 Images} *)

(* Number by number as a sum of two doubles, the second with a prime; written
   out, since rays pass through here wherever they enter a group. *)

(* What (a x + b y + c z) + t = s + t = v has lost. *)
let[@inline] lost a b c a' b' c' t t' x y z x' y' z' s v =
  let open Error_free in
  sum_error s t v
  +. (t' +. dot_error a b c x y z s +. dot a' b' c' x y z +. dot a b c x' y' z')

(* The linear part of a map, applied to v + v', and [t + t'] added. *)
let image { high = m; low = l } (t : Vec.t) (t' : Vec.t) (v : Vec.t)
    (v' : Vec.t) =
  let open Error_free in
  let x = v.x and y = v.y and z = v.z in
  let x' = v'.x and y' = v'.y and z' = v'.z in
  let sx = dot m.xx m.xy m.xz x y z
  and sy = dot m.yx m.yy m.yz x y z
  and sz = dot m.zx m.zy m.zz x y z in
  let px = sx +. t.x and py = sy +. t.y and pz = sz +. t.z in
  let ex = lost m.xx m.xy m.xz l.xx l.xy l.xz t.x t'.x x y z x' y' z' sx px
  and ey = lost m.yx m.yy m.yz l.yx l.yy l.yz t.y t'.y x y z x' y' z' sy py
  and ez = lost m.zx m.zy m.zz l.zx l.zy l.zz t.z t'.z x y z x' y' z' sz pz in
  let qx = px +. ex and qy = py +. ey and qz = pz +. ez in
  ( Vec.v qx qy qz,
    Vec.v (sum_error px ex qx) (sum_error py ey qy) (sum_error pz ez qz) )

let translation (m : Affine.t) = Vec.v m.xt m.yt m.zt
let vector m v r = image m Vec.zero Vec.zero v r
let displaced m v r = image m (translation m.high) (translation m.low) v r

let point m p r =
  let v, rest = displaced m (Point.sub p Point.origin) r in
  (Point.add Point.origin v, rest)

let point_error m p e =
  let unseen = Vec.scale 0x1p-46 (Affine.point_error m.high p) in
  Vec.add unseen (Affine.spread m.high e)

(* {1 Making} *)

let after b a =
  let high = Affine.columns a.high and low = Affine.columns a.low in
  let x, x' = vector b high.x low.x
  and y, y' = vector b high.y low.y
  and z, z' = vector b high.z low.z
  and t, t' = displaced b high.t low.t in
  {
    high = Affine.of_columns { x; y; z; t };
    low = Affine.of_columns { x = x'; y = y'; z = z'; t = t' };
  }

let is_finite m =
  let finite m =
    let { Affine.x; y; z; t } = Affine.columns m in
    List.for_all Vec.is_finite [ x; y; z; t ]
  in
  finite m.high && finite m.low

let of_rows (xx, xy, xz, xt) (yx, yy, yz, yt) (zx, zy, zz, zt) =
  let part of_ =
    {
      Affine.xx = of_ xx;
      xy = of_ xy;
      xz = of_ xz;
      xt = of_ xt;
      yx = of_ yx;
      yy = of_ yy;
      yz = of_ yz;
      yt = of_ yt;
      zx = of_ zx;
      zy = of_ zy;
      zz = of_ zz;
      zt = of_ zt;
    }
  in
  {
    high = part (fun (e : Error_free.t) -> e.hi);
    low = part (fun (e : Error_free.t) -> e.lo);
  }

(* The rows of the inverse are the cross products of columns over the
   determinant. Columns are first brought near 1 by powers of two, so that tiny
   and huge scales neither underflow nor overflow. *)
let inverse m =
  let near_one v =
    let e = Vec.exponent v in
    (Unrounded.vec (Vec.ldexp (-e) v), e)
  in
  let { Affine.x; y; z; t } = Affine.columns m in
  let x, ex = near_one x and y, ey = near_one y and z, ez = near_one z in
  let t, et = near_one t in
  let open Expansion in
  let yz = cross y z in
  let det = dot x yz in
  if sign det = 0 then None
  else
    let over e n =
      let { Error_free.hi; lo } = ratio_pair n det in
      { Error_free.hi = Float.ldexp hi (-e); lo = Float.ldexp lo (-e) }
    in
    let row e (r : vec) =
      (over e r.x, over e r.y, over e r.z, over (e - et) (neg (dot r t)))
    in
    let inverse =
      of_rows (row ex yz) (row ey (cross z x)) (row ez (cross x y))
    in
    if is_finite inverse then Some inverse else None
