open Candor_number

type t = { high : Affine.t; low : Affine.t; mild : bool }

let is_mild ({ xx; xy; xz; yx; yy; yz; zx; zy; zz; _ } : Affine.t) =
  let is = Error_free.is_mild in
  is xx && is xy && is xz && is yx && is yy && is yz && is zx && is zy && is zz

let v high low = { high; low; mild = is_mild high }
let of_affine high = v high Affine.zero

(* {1 Images} *)

(* Number by number as a sum of two doubles, the second with a prime; written
   out, since rays pass through here wherever they enter a group. *)

(* What a scalar product has lost, [e] of it by rounding. *)
let[@inline] lost a b c a' b' c' x y z x' y' z' e =
  let open Error_free in
  e +. dot a' b' c' x y z +. dot a b c x' y' z'

(* The linear part of a map, applied to v + v', and [t + t'] added. *)
let image { high = m; low = l; _ } (t : Vec.t) (t' : Vec.t) (v : Vec.t)
    (v' : Vec.t) =
  let open Error_free in
  let x = v.x and y = v.y and z = v.z in
  let x' = v'.x and y' = v'.y and z' = v'.z in
  let sx = dot m.xx m.xy m.xz x y z
  and sy = dot m.yx m.yy m.yz x y z
  and sz = dot m.zx m.zy m.zz x y z in
  let px = sx +. t.x and py = sy +. t.y and pz = sz +. t.z in
  let ex = t'.x +. dot_error m.xx m.xy m.xz x y z sx
  and ey = t'.y +. dot_error m.yx m.yy m.yz x y z sy
  and ez = t'.z +. dot_error m.zx m.zy m.zz x y z sz in
  let ex = lost m.xx m.xy m.xz l.xx l.xy l.xz x y z x' y' z' ex
  and ey = lost m.yx m.yy m.yz l.yx l.yy l.yz x y z x' y' z' ey
  and ez = lost m.zx m.zy m.zz l.zx l.zy l.zz x y z x' y' z' ez in
  let ex = sum_error sx t.x px +. ex
  and ey = sum_error sy t.y py +. ey
  and ez = sum_error sz t.z pz +. ez in
  let qx = px +. ex and qy = py +. ey and qz = pz +. ez in
  ( Vec.v qx qy qz,
    Vec.v (sum_error px ex qx) (sum_error py ey qy) (sum_error pz ez qz) )

(* The same for what is neither huge nor tiny, both images at once. No error here
   is -0, so what is not added to a direction, 0, would not change a bit. *)
let mild_ray { high = m; low = l; _ } (o : Point.t) (o' : Vec.t) (d : Vec.t)
    (d' : Vec.t) =
  let open Error_free in
  let ox = o.x and oy = o.y and oz = o.z in
  let dx = d.x and dy = d.y and dz = d.z in
  let ox1 = head ox and oy1 = head oy and oz1 = head oz in
  let dx1 = head dx and dy1 = head dy and dz1 = head dz in
  let a = m.xx and b = m.xy and c = m.xz in
  let a1 = head a and b1 = head b and c1 = head c in
  let s = dot a b c ox oy oz in
  let p = s +. m.xt in
  let e = mild_dot_error a a1 b b1 c c1 ox ox1 oy oy1 oz oz1 s in
  let e = lost a b c l.xx l.xy l.xz ox oy oz o'.x o'.y o'.z (l.xt +. e) in
  let e = sum_error s m.xt p +. e in
  let ox' = p +. e in
  let ox'' = sum_error p e ox' in
  let s = dot a b c dx dy dz in
  let e = mild_dot_error a a1 b b1 c c1 dx dx1 dy dy1 dz dz1 s in
  let e = lost a b c l.xx l.xy l.xz dx dy dz d'.x d'.y d'.z e in
  let dx' = s +. e in
  let dx'' = sum_error s e dx' in
  let a = m.yx and b = m.yy and c = m.yz in
  let a1 = head a and b1 = head b and c1 = head c in
  let s = dot a b c ox oy oz in
  let p = s +. m.yt in
  let e = mild_dot_error a a1 b b1 c c1 ox ox1 oy oy1 oz oz1 s in
  let e = lost a b c l.yx l.yy l.yz ox oy oz o'.x o'.y o'.z (l.yt +. e) in
  let e = sum_error s m.yt p +. e in
  let oy' = p +. e in
  let oy'' = sum_error p e oy' in
  let s = dot a b c dx dy dz in
  let e = mild_dot_error a a1 b b1 c c1 dx dx1 dy dy1 dz dz1 s in
  let e = lost a b c l.yx l.yy l.yz dx dy dz d'.x d'.y d'.z e in
  let dy' = s +. e in
  let dy'' = sum_error s e dy' in
  let a = m.zx and b = m.zy and c = m.zz in
  let a1 = head a and b1 = head b and c1 = head c in
  let s = dot a b c ox oy oz in
  let p = s +. m.zt in
  let e = mild_dot_error a a1 b b1 c c1 ox ox1 oy oy1 oz oz1 s in
  let e = lost a b c l.zx l.zy l.zz ox oy oz o'.x o'.y o'.z (l.zt +. e) in
  let e = sum_error s m.zt p +. e in
  let oz' = p +. e in
  let oz'' = sum_error p e oz' in
  let s = dot a b c dx dy dz in
  let e = mild_dot_error a a1 b b1 c c1 dx dx1 dy dy1 dz dz1 s in
  let e = lost a b c l.zx l.zy l.zz dx dy dz d'.x d'.y d'.z e in
  let dz' = s +. e in
  let dz'' = sum_error s e dz' in
  ( Point.v ox' oy' oz',
    Vec.v ox'' oy'' oz'',
    Vec.v dx' dy' dz',
    Vec.v dx'' dy'' dz'' )

let translation (m : Affine.t) = Vec.v m.xt m.yt m.zt
let vector m v r = image m Vec.zero Vec.zero v r
let displaced m v r = image m (translation m.high) (translation m.low) v r

let point m p r =
  let v, rest = displaced m (Point.sub p Point.origin) r in
  (Point.add Point.origin v, rest)

let wild_ray m o o' d d' =
  let p, p' = point m o o' and v, v' = vector m d d' in
  (p, p', v, v')

let ray m (o : Point.t) o' (d : Vec.t) d' =
  let is = Error_free.is_mild in
  if m.mild && is o.x && is o.y && is o.z && is d.x && is d.y && is d.z then
    mild_ray m o o' d d'
  else wild_ray m o o' d d'

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
  v
    (Affine.of_columns { x; y; z; t })
    (Affine.of_columns { x = x'; y = y'; z = z'; t = t' })

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
  v
    (part (fun (e : Error_free.t) -> e.hi))
    (part (fun (e : Error_free.t) -> e.lo))

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
