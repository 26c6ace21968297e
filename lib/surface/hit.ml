open Candor_space

type 'm t = {
  t : float;
  point : Point.t;
  normal : Dir.t;
  shading_normal : Dir.t;
  side : Side.t;
  path : int list;
  part : int;
  uv : (float * float) option Lazy.t;
  offset : float;
  local : Local.t;
  material : 'm;
}

(* A place on its way out of nested groups, at [at + rest]. *)
type carried = {
  at : Point.t;
  rest : Vec.t;
  error : Vec.t;
  outward : Dir.t;
  smooth : Dir.t option;
}

let carry place transform =
  let forward = Transform.forward transform
  and backward = Transform.backward transform in
  let turn n =
    Dir.of_vec_or n (Affine.transposed backward.high (n : Dir.t :> Vec.t))
  in
  let at, rest = Wide_affine.point forward place.at place.rest in
  {
    at;
    rest;
    error = Wide_affine.point_error forward place.at place.error;
    outward = turn place.outward;
    smooth = Option.map turn place.smooth;
  }

let v ~t ~math contact (local : Local.t) ~groups ~path material =
  let place =
    List.fold_left carry
      {
        at = local.point;
        rest = Vec.zero;
        error = local.error;
        outward = local.normal;
        smooth = local.shading_normal;
      }
      groups
  in
  let side = Contact.side contact in
  let facing n = match side with Side.Outside -> n | Inside -> Dir.neg n in
  let normal = facing place.outward in
  let shading_normal =
    match place.smooth with
    | None -> normal
    | Some n -> if Dir.dot n normal < 0. then Dir.neg n else n
  in
  let { Vec.x; y; z } = (normal :> Vec.t) in
  let e = Vec.add (Vec.abs place.rest) place.error in
  {
    t;
    point = place.at;
    normal;
    shading_normal;
    side;
    path;
    part = Contact.part contact;
    uv = local.uv;
    offset =
      (match (math : Math.t) with
      | Stable ->
          (Float.abs x *. e.x) +. (Float.abs y *. e.y) +. (Float.abs z *. e.z)
      | Textbook -> 0.);
    local;
    material;
  }

(* One step of rounding in the direction of the move, so that the move is never
   rounded away. *)
let outward move x =
  if move > 0. then Float.succ (x +. move)
  else if move < 0. then Float.pred (x +. move)
  else x

let spawn h d =
  let n = (h.normal :> Vec.t) in
  let leaves_back = Vec.dot n d < 0. in
  let k = if leaves_back then -.h.offset else h.offset in
  let side = if leaves_back then Side.opposite h.side else h.side in
  let { Point.x; y; z } = h.point in
  let origin =
    Point.v (outward (k *. n.x) x) (outward (k *. n.y) y) (outward (k *. n.z) z)
  in
  Ray.leaving (Surface { path = h.path; part = h.part; side }) origin d
