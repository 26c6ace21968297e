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

let absolute m =
  let abs = Float.abs in
  {
    xx = abs m.xx;
    xy = abs m.xy;
    xz = abs m.xz;
    xt = abs m.xt;
    yx = abs m.yx;
    yy = abs m.yy;
    yz = abs m.yz;
    yt = abs m.yt;
    zx = abs m.zx;
    zy = abs m.zy;
    zz = abs m.zz;
    zt = abs m.zt;
  }

(* Four products and three sums make at most four roundings each. *)
let rounding = 5. *. 0x1p-53

let point_error m { Point.x; y; z } =
  let size =
    point (absolute m) (Point.v (Float.abs x) (Float.abs y) (Float.abs z))
  in
  Vec.scale rounding (Point.sub size Point.origin)

let spread m e = Vec.scale (1. +. rounding) (vector (absolute m) e)

type columns = { x : Vec.t; y : Vec.t; z : Vec.t; t : Vec.t }

let columns m =
  {
    x = Vec.v m.xx m.yx m.zx;
    y = Vec.v m.xy m.yy m.zy;
    z = Vec.v m.xz m.yz m.zz;
    t = Vec.v m.xt m.yt m.zt;
  }

let of_columns { x; y; z; t } =
  {
    xx = x.x;
    xy = y.x;
    xz = z.x;
    xt = t.x;
    yx = x.y;
    yy = y.y;
    yz = z.y;
    yt = t.y;
    zx = x.z;
    zy = y.z;
    zz = z.z;
    zt = t.z;
  }

let zero = of_columns { x = Vec.zero; y = Vec.zero; z = Vec.zero; t = Vec.zero }
