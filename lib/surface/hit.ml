open Candor_number
open Candor_space

type 'm t = {
  t : float;
  point : Point.t;
  normal : Dir.t;
  shading_normal : Dir.t;
  side : Side.t;
  path : int list;
  part : int;
  lift : Vec.t option;
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
  smooth : Local.smooth option;
}

let curved ~turn map { Local.outward; above; below } =
  let across = Affine.vector map in
  { Local.outward = turn outward; above = across above; below = across below }

let through transform place =
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
    smooth = Option.map (curved ~turn forward.high) place.smooth;
  }

let moved by place =
  let map = Motion.map by in
  let at, rest = Wide_affine.point map place.at place.rest in
  let error = Wide_affine.point_error map place.at place.error in
  { place with at; rest; error }

let rec carry place : Way.t -> carried = function
  | Outermost -> place
  | Within { transform = None; around; _ } -> carry place around
  | Within { transform = Some m; around; _ } -> carry (through m place) around
  | Moved { by; around } -> carry (moved by place) around

let carried (local : Local.t) way =
  carry
    {
      at = local.point;
      rest = Vec.zero;
      error = local.error;
      outward = local.normal;
      smooth = local.smooth;
    }
    way

(* How far the true surface may be from [place.at] along [n]. *)
let reach { rest; error; _ } (n : Vec.t) =
  (Float.abs n.x *. (Float.abs rest.x +. error.x))
  +. (Float.abs n.y *. (Float.abs rest.y +. error.y))
  +. (Float.abs n.z *. (Float.abs rest.z +. error.z))

let some_lift v = if Vec.largest v > 0. then Some v else None

let v ~t ~math contact (local : Local.t) way i material =
  let place = carried local way in
  let side = Contact.side contact in
  let normal =
    match side with
    | Side.Outside -> place.outward
    | Inside -> Dir.neg place.outward
  in
  let shading_normal =
    match place.smooth with
    | None -> normal
    | Some { outward = n; _ } -> if Dir.dot n normal < 0. then Dir.neg n else n
  and lift =
    match place.smooth with
    | None -> None
    | Some { outward; above; below } ->
        some_lift (if Dir.dot outward normal < 0. then below else above)
  in
  {
    t;
    point = place.at;
    normal;
    shading_normal;
    side;
    path = Way.path way i;
    part = Contact.part contact;
    lift;
    offset =
      (match (math : Math.t) with
      | Stable -> reach place (normal :> Vec.t)
      | Textbook -> 0.);
    local;
    material;
  }

(* One step of rounding in the direction of the move, so that the move is never
   rounded away. *)
let outward move x =
  if move > 0. then Neighbour.succ (x +. move)
  else if move < 0. then Neighbour.pred (x +. move)
  else x

let[@inline] moved_off { Point.x; y; z } (n : Vec.t) k =
  Point.v (outward (k *. n.x) x) (outward (k *. n.y) y) (outward (k *. n.z) z)

(* The ray that leaves [h] along [d], moved off it by [clearance]. *)
let[@inline] leave h d ~leaves_back ~clearance =
  let side = if leaves_back then Side.opposite h.side else h.side in
  let origin = moved_off h.point (h.normal :> Vec.t) clearance in
  Ray.leaving (Surface { path = h.path; part = h.part; side }) origin d

let spawn h d =
  let leaves_back = Vec.dot (h.normal :> Vec.t) d < 0. in
  leave h d ~leaves_back
    ~clearance:(if leaves_back then -.h.offset else h.offset)

(* {1 Surfaces that touch} *)

type place = { onto : Ray.t; limit : float; clearance : float }

(* The rounding of the point, and of one as far away as the ray has come. *)
let place h d =
  let { Point.x; y; z } = h.point in
  let size = Float.max (Vec.largest (Vec.v x y z)) (h.t *. Vec.norm d) in
  let clearance = h.offset +. (0x1p-51 *. size) in
  let across = Float.abs (Vec.dot (h.normal :> Vec.t) d) in
  {
    onto = leave h d ~leaves_back:true ~clearance;
    limit = 3. *. clearance /. across;
    clearance;
  }

let spawn_clear h { clearance; _ } d =
  let leaves_back = Vec.dot (h.normal :> Vec.t) d < 0. in
  leave h d ~leaves_back
    ~clearance:(if leaves_back then -.clearance else clearance)

(* {1 Light that falls on a surface} *)

let faces h (d : Vec.t) =
  let ahead (n : Dir.t) = Vec.dot (n :> Vec.t) d > 0. in
  (ahead h.normal || Option.is_some h.lift) && ahead h.shading_normal

let lit_point h =
  match h.lift with None -> h.point | Some by -> Point.add h.point by

let spawn_lit h d =
  match h.lift with
  | None -> spawn h d
  | Some by ->
      let { path; part; side; _ } = h in
      let lit = Point.add h.point by in
      let origin = moved_off lit (h.normal :> Vec.t) h.offset in
      Ray.leaving (Surface { path; part; side }) origin d
