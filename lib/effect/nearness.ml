open Candor_space
open Candor_surface
open Candor_scene

(* What rounding leaves in doubt of a distance between coordinates of this size,
   with a wide margin. *)
let certain size distance = Float.max 0. (distance -. (0x1p-40 *. size))
let size (p : Point.t) = Vec.norm1 (Point.sub p Point.origin)

let reach (b : Bounds.t) (p : Point.t) =
  size (Bounds.low b) +. size (Bounds.high b) +. size p

let is_empty (b : Bounds.t) = b.x0 > b.x1 || b.y0 > b.y1 || b.z0 > b.z1
let outside low high x = Float.max 0. (Float.max (low -. x) (x -. high))
let inside low high x = Float.min (x -. low) (high -. x)

let to_bounds (b : Bounds.t) (p : Point.t) =
  if is_empty b then infinity
  else if not (Bounds.is_finite b) then 0.
  else
    Vec.v (outside b.x0 b.x1 p.x) (outside b.y0 b.y1 p.y)
      (outside b.z0 b.z1 p.z)
    |> Vec.norm
    |> certain (reach b p)

(* {1 Shapes as they are} *)

let to_box (b : Bounds.t) (p : Point.t) =
  if Bounds.mem p b then
    let x = inside b.x0 b.x1 p.x
    and y = inside b.y0 b.y1 p.y
    and z = inside b.z0 b.z1 p.z in
    certain (reach b p) (Float.min x (Float.min y z))
  else to_bounds b p

let to_sphere (s : Sphere.t) p =
  let center = Sphere.center s in
  let from_center = Vec.norm (Point.sub p center) in
  certain
    (size center +. size p +. s.radius)
    (Float.abs (from_center -. s.radius))

let to_plane (normal : Vec.t) offset (p : Point.t) =
  let at = Point.sub p Point.origin and length = Vec.norm normal in
  let sizes = Vec.dot (Vec.abs normal) (Vec.abs at) +. Float.abs offset in
  certain (sizes /. length) (Float.abs (Vec.dot normal at -. offset) /. length)

let of_quadric q =
  match Quadric.shape q with
  | Plane { normal; offset } when Option.is_none (Quadric.clip q) ->
      Some (to_plane normal offset)
  | Plane _ | Matrix _ | Form _ | Ellipsoid _ | Cylinder _ | Cone _
  | Paraboloid _ | Hyperbolic_paraboloid _ | Hyperboloid_one_sheet _
  | Hyperboloid_two_sheets _ ->
      None

let exactly (s : Scene.surface) =
  if not (Scene.is_still s) then None
  else
    match s.shape with
    | Sphere s -> Some (to_sphere s)
    | Box b -> Some (to_box (Box.bounds b))
    | Quadric q -> of_quadric q
    | Triangle _ | Polygon _ | Mesh _ | Group _ | Use _ -> None

(* {1 All of them} *)

(* What stands in groups that move nothing stands where it is written. *)
let rec laid_open (s : Scene.surface) =
  match s.shape with
  | Group { transform = []; surfaces } when Scene.is_still s ->
      List.concat_map laid_open surfaces
  | Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Mesh _ | Use _
  | Group _ ->
      [ s ]

(* Finer boxes are nearer to what they hold. *)
let depth = 12

let to_surfaces (scene : Scene.t) =
  let shape s =
    match exactly s with Some f -> Either.Left f | None -> Right s
  in
  let known, surfaces =
    List.partition_map shape (List.concat_map laid_open scene.surfaces)
  in
  let rest = Assembly.surface ~dress:ignore { scene with surfaces } in
  let boxes = List.map to_bounds (Surface.cover rest ~depth) in
  let all = known @ boxes in
  fun p -> List.fold_left (fun least f -> Float.min least (f p)) infinity all
