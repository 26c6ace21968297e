open Candor_number

type step =
  | Translate of Vec.t
  | Scale of Vec.t
  | Rotate of { axis : Vec.t; degrees : float }
  | Matrix of Affine.t
[@@deriving show, eq, ord]

type t = { forward : Wide_affine.t; backward : Wide_affine.t }

let forward m = m.forward
let backward m = m.backward

let after b a =
  {
    forward = Wide_affine.after b.forward a.forward;
    backward = Wide_affine.after a.backward b.backward;
  }

let identity =
  let m = Wide_affine.of_affine Affine.identity in
  { forward = m; backward = m }

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

let invertible m =
  Option.map
    (fun backward -> { forward = Wide_affine.of_affine m; backward })
    (Wide_affine.inverse m)

let of_step = function
  | Translate v ->
      Option.to_result ~none:"a translation must be finite"
        (invertible { Affine.identity with xt = v.x; yt = v.y; zt = v.z })
  | Scale v ->
      Option.to_result ~none:"a scale by zero cannot be undone"
        (invertible { Affine.identity with xx = v.x; yy = v.y; zz = v.z })
  | Rotate { axis; degrees } ->
      let turn axis = invertible (rotation (axis : Dir.t :> Vec.t) degrees) in
      Option.to_result ~none:"a rotation needs an axis that is not zero"
        (Option.bind (Dir.of_vec axis) turn)
  | Matrix m ->
      Option.to_result ~none:"this matrix is singular: it cannot be undone"
        (invertible m)

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
      if Wide_affine.(is_finite m.forward && is_finite m.backward) then Ok m
      else Error "these steps together go beyond the numbers that fit"
