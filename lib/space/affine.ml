open Candor_number

type t = {
  xx : float;
  xy : float;
  xz : float;
  xt : float;
  yx : float;
  yy : float;
  yz : float;
  yt : float;
  zx : float;
  zy : float;
  zz : float;
  zt : float;
}
[@@deriving show, eq, ord]

let identity =
  {
    xx = 1.;
    xy = 0.;
    xz = 0.;
    xt = 0.;
    yx = 0.;
    yy = 1.;
    yz = 0.;
    yt = 0.;
    zx = 0.;
    zy = 0.;
    zz = 1.;
    zt = 0.;
  }

let[@inline] row a b c t x y z = (a *. x) +. (b *. y) +. (c *. z) +. t

let point m { Point.x; y; z } =
  Point.v
    (row m.xx m.xy m.xz m.xt x y z)
    (row m.yx m.yy m.yz m.yt x y z)
    (row m.zx m.zy m.zz m.zt x y z)

let vector m { Vec.x; y; z } =
  Vec.v
    (row m.xx m.xy m.xz 0. x y z)
    (row m.yx m.yy m.yz 0. x y z)
    (row m.zx m.zy m.zz 0. x y z)

let transposed m { Vec.x; y; z } =
  Vec.v
    (row m.xx m.yx m.zx 0. x y z)
    (row m.xy m.yy m.zy 0. x y z)
    (row m.xz m.yz m.zz 0. x y z)

let point_error m (p : Point.t) (e : Vec.t) =
  let abs = Float.abs in
  (* Four products and three sums make at most four roundings each. *)
  let g = 5. *. 0x1p-53 in
  let bound a b c t =
    let spread = row (abs a) (abs b) (abs c) 0. e.x e.y e.z in
    let size =
      row (abs a) (abs b) (abs c) (abs t) (abs p.x) (abs p.y) (abs p.z)
    in
    ((1. +. g) *. spread) +. (g *. size)
  in
  Vec.v
    (bound m.xx m.xy m.xz m.xt)
    (bound m.yx m.yy m.yz m.yt)
    (bound m.zx m.zy m.zz m.zt)

let column_x m = Vec.v m.xx m.yx m.zx
let column_y m = Vec.v m.xy m.yy m.zy
let column_z m = Vec.v m.xz m.yz m.zz
let determinant m = Vec.dot (column_x m) (Vec.cross (column_y m) (column_z m))

let of_columns (a : Vec.t) (b : Vec.t) (c : Vec.t) (t : Vec.t) =
  {
    xx = a.x;
    xy = b.x;
    xz = c.x;
    xt = t.x;
    yx = a.y;
    yy = b.y;
    yz = c.y;
    yt = t.y;
    zx = a.z;
    zy = b.z;
    zz = c.z;
    zt = t.z;
  }

let after b a =
  let moved = point b (Point.v a.xt a.yt a.zt) in
  of_columns
    (vector b (column_x a))
    (vector b (column_y a))
    (vector b (column_z a))
    (Point.sub moved Point.origin)

let is_finite m =
  Vec.is_finite (column_x m)
  && Vec.is_finite (column_y m)
  && Vec.is_finite (column_z m)
  && Vec.is_finite (Vec.v m.xt m.yt m.zt)

(* Whether three columns are in one plane, exactly. *)
let singular a b c =
  let a = Unrounded.vec a and b = Unrounded.vec b and c = Unrounded.vec c in
  Expansion.(sign (dot a (cross b c))) = 0

(* The inverse of rows is the cofactors over the determinant. Columns are first
   brought near 1 by powers of two, so that tiny and huge scales neither
   underflow nor overflow. *)
let inverse m =
  let exponent c = snd (Float.frexp (Vec.largest c)) in
  let shift e (c : Vec.t) =
    Vec.v (Float.ldexp c.x e) (Float.ldexp c.y e) (Float.ldexp c.z e)
  in
  let a = column_x m and b = column_y m and c = column_z m in
  let ea = -exponent a and eb = -exponent b and ec = -exponent c in
  let a = shift ea a and b = shift eb b and c = shift ec c in
  let bc = Vec.cross b c and ca = Vec.cross c a and ab = Vec.cross a b in
  let det = Vec.dot a bc in
  if singular a b c then None
  else
    let over e (r : Vec.t) =
      shift e (Vec.v (r.x /. det) (r.y /. det) (r.z /. det))
    in
    let ra = over ea bc and rb = over eb ca and rc = over ec ab in
    let linear =
      {
        xx = ra.x;
        xy = ra.y;
        xz = ra.z;
        xt = 0.;
        yx = rb.x;
        yy = rb.y;
        yz = rb.z;
        yt = 0.;
        zx = rc.x;
        zy = rc.y;
        zz = rc.z;
        zt = 0.;
      }
    in
    let back = vector linear (Vec.v (-.m.xt) (-.m.yt) (-.m.zt)) in
    let inverse = { linear with xt = back.x; yt = back.y; zt = back.z } in
    if is_finite inverse then Some inverse else None
