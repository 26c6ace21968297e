open Candor_space

type axial = { frame : Frame.t; axis : Vec.t; length2 : float }
type texture_map = No_map | Planar of int | Axial of axial

type t = {
  shape : Quadric_shape.t;
  clip : Bounds.t option;
  caps : bool;
  body : Cut_form.t;
  bounds : Bounds.t;
  map : texture_map;
}

let shape q = q.shape
let clip q = q.clip
let caps q = q.caps
let body q = q.body
let bounds q = q.bounds
let meet q ray left cursor = Cut_form.meet q.body ray left cursor
let written q = (q.shape, q.clip, q.caps)

type written = Quadric_shape.t * Bounds.t option * bool
[@@deriving show, eq, ord]

let equal a b = equal_written (written a) (written b)
let compare a b = compare_written (written a) (written b)
let pp ppf q = pp_written ppf (written q)
let show q = show_written (written q)

(* {1 Making} *)

let check_clip = function
  | None -> Ok ()
  | Some (b : Bounds.t) ->
      if b.x0 > b.x1 || b.y0 > b.y1 || b.z0 > b.z1 then
        Error "the clip box is empty: min is above max"
      else if not (Reach.point (Bounds.low b) && Reach.point (Bounds.high b))
      then Error Reach.message
      else Ok ()

(* The ends of an axial shape: n.(x - first) <= |n|^2 is part 1's plane, and
   -n.(x - first) <= 0 part 2's. *)
let ends first axis =
  let { Point.x = px; y = py; z = pz } = first in
  let { Vec.x = nx; y = ny; z = nz } = axis in
  [|
    { Half_space.nx; ny; nz; px; py; pz; c = Vec.dot axis axis };
    { Half_space.nx = -.nx; ny = -.ny; nz = -.nz; px; py; pz; c = 0. };
  |]

let closed_ends caps : Quadric_shape.t -> int array = function
  | Cylinder _ when caps -> [| 0; 1 |]
  | (Cone _ | Paraboloid _) when caps -> [| 0 |]
  | Cylinder _ | Cone _ | Paraboloid _ | Matrix _ | Form _ | Plane _
  | Ellipsoid _ | Hyperbolic_paraboloid _ | Hyperboloid_one_sheet _
  | Hyperboloid_two_sheets _ ->
      [||]

let largest_axis (v : Vec.t) =
  let x = Float.abs v.x and y = Float.abs v.y and z = Float.abs v.z in
  if x >= y && x >= z then 0 else if y >= z then 1 else 2

let map_of (shape : Quadric_shape.t) axial =
  match (shape, axial) with
  | Plane { normal; _ }, _ -> Planar (largest_axis normal)
  | _, None -> No_map
  | _, Some { Quadric_shape.first; second; radius = _ } -> (
      let axis = Point.sub second first in
      match Dir.of_vec axis with
      | None -> No_map
      | Some w ->
          Axial { frame = Frame.of_dir w; axis; length2 = Vec.dot axis axis })

let make ?clip ?(caps = false) shape =
  let axial = Quadric_shape.ends shape in
  match (Quadric_shape.check shape, check_clip clip) with
  | (Error _ as e), _ | _, (Error _ as e) -> e
  | Ok (), Ok () when caps && Option.is_none axial ->
      Error "only a cylinder, a cone or a paraboloid has ends to cap"
  | Ok (), Ok () ->
      let form = Form.of_shape shape in
      let cuts =
        match axial with
        | None -> [||]
        | Some { first; second; radius = _ } ->
            ends first (Point.sub second first)
      in
      let clip_cuts = Option.fold ~none:[] ~some:Half_space.of_bounds clip in
      let clip_box = Option.value clip ~default:Bounds.everything in
      if Form.is_constant form then
        Error
          "F is constant: it has no surface (all coefficients but the last are \
           0)"
      else
        Ok
          {
            shape;
            clip;
            caps;
            body =
              Cut_form.make form
                ~cuts:(Array.append cuts (Array.of_list clip_cuts))
                ~disks:(closed_ends caps shape);
            bounds = Bounds.meet (Quadric_shape.bounds shape) clip_box;
            map = map_of shape axial;
          }

(* {1 Locating} *)

let turn (frame : Frame.t) y =
  let on (d : Dir.t) = Vec.dot (d :> Vec.t) y in
  let a = Float.atan2 (on frame.v) (on frame.u) /. (2. *. Float.pi) in
  if a < 0. then a +. 1. else a

let uv q (p : Point.t) y =
  match q.map with
  | No_map -> None
  | Planar 0 -> Some (p.y, p.z)
  | Planar 1 -> Some (p.x, p.z)
  | Planar _ -> Some (p.x, p.y)
  | Axial { frame; axis; length2 } ->
      Some (turn frame y, Vec.dot axis y /. length2)

let rounding (p : Point.t) =
  let u x = 0x1p-52 *. Float.abs x in
  Vec.v (u p.x) (u p.y) (u p.z)

(* Where t is not fine enough to say where on the surface a ray from far away
   ends, the way from the point of the ray nearest to the centre is. *)
let from_closest form (ray : Object_ray.t) contact =
  let center = Form.center form and d = ray.direction in
  let y = Object_ray.closest ray center in
  let g = Form.gradient form y in
  let a = Vec.dot d (Form.times form d)
  and b = Vec.dot g d
  and c = (Form.value form y Vec.zero).hi in
  let root = sqrt (Float.max 0. ((b *. b) -. (a *. c))) in
  let root =
    match Contact.side contact with Outside -> -.root | Inside -> root
  in
  let t = if b *. root < 0. then (root -. b) /. a else c /. -.(b +. root) in
  Point.add center (Vec.along y d t)

(* From this many times its distance to the origin: there t is as coarse as the
   root of a grazing ray's discriminant. *)
let far = 0x1p26

let near_hit form (ray : Object_ray.t) t contact =
  let direct = Point.along ray.origin ray.direction t in
  let size = Vec.largest (Point.sub direct Point.origin) in
  let reach = t *. Vec.largest ray.direction in
  if not (reach > far *. size) then direct
  else
    let p = from_closest form ray contact in
    if Point.is_finite p then p else direct

let most_steps = 64

(* One Newton step from [p] along the gradient g: where to, g, and how far the
   surface can still be, from the curvature that the step ignores and the
   rounding of g. *)
let step (form : Form.t) p =
  let center = Form.center form in
  let y = Point.sub p center in
  let g = Form.gradient form y in
  let f = (Form.value form y (Unrounded.diff_error p center y)).hi in
  let g2 = Vec.dot g g in
  let k = f /. (2. *. g2) in
  let bend = Vec.dot g (Form.times form g) in
  let doubt = 0x1p-48 *. Float.abs k *. Vec.norm1 (Form.gradient_size form y) in
  let left_over = doubt +. (k *. k *. Float.abs bend /. sqrt g2) in
  if Float.is_finite left_over then (Point.along p g (-.k), g, left_over)
  else (p, g, 0.)

(* One step does, but near an apex, towards which each step halves the distance;
   as long as they come nearer. *)
let rec settle form steps ((p, _, left_over) as settled) =
  let size = Vec.largest (Point.sub p Point.origin) in
  if steps = 0 || left_over <= 0x1p-54 *. size then settled
  else
    let ((_, _, less) as next) = step form p in
    if less < 0.75 *. left_over then settle form (steps - 1) next else settled

let locate_surface q (ray : Object_ray.t) t contact =
  let form = q.body.form in
  let point, g, left_over =
    settle form most_steps (step form (near_hit form ray t contact))
  in
  let normal = Dir.of_vec_or (Dir.of_vec_or Dir.z (Vec.neg ray.direction)) g in
  let n = (normal :> Vec.t) and r = rounding point in
  let spread n r = (Float.abs n *. left_over) +. r in
  {
    Local.point;
    normal;
    error = Vec.v (spread n.x r.x) (spread n.y r.y) (spread n.z r.z);
    flat = q.body.linear;
    uv = lazy (uv q point (Point.sub point (Form.center form)));
    smooth = None;
  }

let locate_disk q (ray : Object_ray.t) t end_ =
  let h = q.body.cuts.(end_) in
  let n = Vec.v h.nx h.ny h.nz in
  let first = Point.along ray.origin ray.direction t in
  let depth = Half_space.depth h (Object_ray.v first ray.direction) in
  let move = Vec.scale (depth /. Vec.dot n n) n in
  let point = Point.add first move in
  let rounded = rounding (Point.add Point.origin move) in
  {
    Local.point;
    normal = Dir.of_vec_or Dir.z n;
    error = Vec.scale 4. (Vec.add (rounding point) rounded);
    flat = true;
    uv = lazy (uv q point (Point.sub point (Form.center q.body.form)));
    smooth = None;
  }

let locate q ray t contact =
  match Contact.part contact with
  | 0 -> locate_surface q ray t contact
  | part -> locate_disk q ray t (part - 1)
