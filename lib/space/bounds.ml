type t = {
  x0 : float;
  y0 : float;
  z0 : float;
  x1 : float;
  y1 : float;
  z1 : float;
}
[@@deriving show, eq, ord]

let empty =
  {
    x0 = infinity;
    y0 = infinity;
    z0 = infinity;
    x1 = neg_infinity;
    y1 = neg_infinity;
    z1 = neg_infinity;
  }

let v (a : Point.t) (b : Point.t) =
  { x0 = a.x; y0 = a.y; z0 = a.z; x1 = b.x; y1 = b.y; z1 = b.z }

let everything =
  v
    (Point.v neg_infinity neg_infinity neg_infinity)
    (Point.v infinity infinity infinity)

let[@inline] least (a : float) b = if a < b then a else b
let[@inline] greatest (a : float) b = if a > b then a else b

let join a b =
  {
    x0 = least a.x0 b.x0;
    y0 = least a.y0 b.y0;
    z0 = least a.z0 b.z0;
    x1 = greatest a.x1 b.x1;
    y1 = greatest a.y1 b.y1;
    z1 = greatest a.z1 b.z1;
  }

let meet a b =
  {
    x0 = greatest a.x0 b.x0;
    y0 = greatest a.y0 b.y0;
    z0 = greatest a.z0 b.z0;
    x1 = least a.x1 b.x1;
    y1 = least a.y1 b.y1;
    z1 = least a.z1 b.z1;
  }

let of_points ps = List.fold_left (fun b p -> join b (v p p)) empty ps

let widen e b =
  let down x = Float.pred (x -. e) and up x = Float.succ (x +. e) in
  {
    x0 = down b.x0;
    y0 = down b.y0;
    z0 = down b.z0;
    x1 = up b.x1;
    y1 = up b.y1;
    z1 = up b.z1;
  }

let low b = Point.v b.x0 b.y0 b.z0
let high b = Point.v b.x1 b.y1 b.z1
let is_finite b = Point.is_finite (low b) && Point.is_finite (high b)

let mem (p : Point.t) b =
  b.x0 <= p.x && p.x <= b.x1 && b.y0 <= p.y && p.y <= b.y1 && b.z0 <= p.z
  && p.z <= b.z1

let corners b =
  let pick lo hi bit = if bit = 0 then lo else hi in
  List.init 8 (fun i ->
      Point.v
        (pick b.x0 b.x1 (i land 1))
        (pick b.y0 b.y1 (i land 2))
        (pick b.z0 b.z1 (i land 4)))

let transform m b =
  if not (is_finite b) then if b.x0 > b.x1 then empty else everything
  else
    let add acc p =
      let image, rest = Wide_affine.point m p Vec.zero in
      let { Vec.x; y; z } =
        Vec.add (Vec.abs rest) (Wide_affine.point_error m p Vec.zero)
      in
      let e = greatest x (greatest y z) in
      join acc (widen e (v image image))
    in
    List.fold_left add empty (corners b)
