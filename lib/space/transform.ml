open Candor_number

type step =
  | Translate of Vec.t
  | Scale of Vec.t
  | Rotate of { axis : Vec.t; degrees : float }
  | Matrix of Affine.t
[@@deriving show, eq, ord]

type t = { forward : Affine.t; backward : Affine.t }

let identity = { forward = Affine.identity; backward = Affine.identity }
let forward m = m.forward
let backward m = m.backward

let after b a =
  {
    forward = Affine.after b.forward a.forward;
    backward = Affine.after a.backward b.backward;
  }

let translation (v : Vec.t) =
  { Affine.identity with xt = v.x; yt = v.y; zt = v.z }

let scaling (v : Vec.t) = { Affine.identity with xx = v.x; yy = v.y; zz = v.z }

(* O. Rodrigues' formula: the rotation by an angle about a unit axis. *)
let rotation (axis : Vec.t) degrees =
  let c = Angle.cos degrees and s = Angle.sin degrees in
  let { Vec.x; y; z } = axis in
  let d = 1. -. c in
  {
    Affine.identity with
    xx = (d *. x *. x) +. c;
    xy = (d *. x *. y) -. (s *. z);
    xz = (d *. x *. z) +. (s *. y);
    yx = (d *. y *. x) +. (s *. z);
    yy = (d *. y *. y) +. c;
    yz = (d *. y *. z) -. (s *. x);
    zx = (d *. z *. x) -. (s *. y);
    zy = (d *. z *. y) +. (s *. x);
    zz = (d *. z *. z) +. c;
  }

let of_step = function
  | Translate v ->
      Ok { forward = translation v; backward = translation (Vec.neg v) }
  | Scale v ->
      let inverse = Vec.v (1. /. v.x) (1. /. v.y) (1. /. v.z) in
      if not (Vec.is_finite inverse) then
        Error "a scale by zero cannot be undone"
      else Ok { forward = scaling v; backward = scaling inverse }
  | Rotate { axis; degrees } -> (
      match Dir.of_vec axis with
      | None -> Error "a rotation needs an axis that is not zero"
      | Some u ->
          let turn = rotation (u :> Vec.t) in
          Ok { forward = turn degrees; backward = turn (-.degrees) })
  | Matrix m -> (
      match Affine.inverse m with
      | None -> Error "this matrix is singular: it cannot be undone"
      | Some inverse -> Ok { forward = m; backward = inverse })

let of_steps steps =
  let add m step =
    match (m, of_step step) with
    | Error _, _ -> m
    | Ok _, (Error _ as e) -> e
    | Ok a, Ok b -> Ok (after b a)
  in
  match List.fold_left add (Ok identity) steps with
  | Error _ as e -> e
  | Ok m ->
      let finite (a : Affine.t) =
        Point.is_finite (Affine.point a (Point.v 1. 1. 1.))
      in
      if finite m.forward && finite m.backward then Ok m
      else Error "these steps together go beyond the numbers that fit"
