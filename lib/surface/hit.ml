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

(* A place on its way out of nested groups. *)
type carried = {
  at : Point.t;
  error : Vec.t;
  outward : Dir.t;
  smooth : Dir.t option;
}

let carry place transform =
  let forward = Transform.forward transform
  and backward = Transform.backward transform in
  let turn n =
    Dir.of_vec_or n (Affine.transposed backward (n : Dir.t :> Vec.t))
  in
  let at = Affine.point forward place.at in
  (* The ray that leaves will be taken back into the group, which rounds too. *)
  let back = Affine.point_error backward at Vec.zero in
  {
    at;
    error = Affine.point_error forward place.at (Vec.add place.error back);
    outward = turn place.outward;
    smooth = Option.map turn place.smooth;
  }

let v ~t contact (local : Local.t) ~groups ~path material =
  let place =
    List.fold_left carry
      {
        at = local.point;
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
  let { Vec.x; y; z } = (normal :> Vec.t) and e = place.error in
  {
    t;
    point = place.at;
    normal;
    shading_normal;
    side;
    path;
    part = Contact.part contact;
    uv = local.uv;
    offset = (Float.abs x *. e.x) +. (Float.abs y *. e.y) +. (Float.abs z *. e.z);
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
  {
    Ray.origin =
      Point.v
        (outward (k *. n.x) x)
        (outward (k *. n.y) y)
        (outward (k *. n.z) z);
    direction = d;
    departure = Surface { path = h.path; part = h.part; side };
  }
