open Candor_space
open Candor_surface
open Candor_scene

(* The side of a wall. *)
type region =
  | Within of { center : Point.t; radius : float }
  | Without of { center : Point.t; radius : float }
  | Below of { at : Point.t; normal : Dir.t }
(* on the far side from where [normal] points *)

type wall = { region : region; path : int list; side : Side.t }
type t = wall list
type part = Whole | Cap of { axis : Dir.t; one_minus_cos : float } | Nothing

(* What rounding may amount to, beside numbers of this size. *)
let slack size = 0x1p-40 *. size
let size (p : Point.t) = Float.abs p.x +. Float.abs p.y +. Float.abs p.z
let distance p q = Vec.norm (Point.sub p q)
let height at normal p = Vec.dot (normal : Dir.t :> Vec.t) (Point.sub p at)

(* How far [p] is inside the region, at least; negative outside it and where
   rounding could decide. *)
let depth region p =
  match region with
  | Within { center; radius } ->
      radius -. distance p center -. slack (radius +. size center)
  | Without { center; radius } ->
      distance p center -. radius -. slack (radius +. size center)
  | Below { at; normal } -> -.height at normal p -. slack (size at +. size p)

let shields wall ~departure p =
  depth wall.region p > 0.
  ||
  match (departure : Ray.departure) with
  | Nowhere -> false
  | Surface { path; side; _ } ->
      Side.equal side wall.side && List.equal Int.equal path wall.path

(* {1 Parts of spheres}

   A point of the sphere at angle θ from the axis towards a centre at distance D
   is at distance √(r² + D² − 2rD cos θ) from that: in a ball of radius R where
   1 − cos θ is at most (R − D + r)(R + D − r)/2rD, outside it where the angle
   from the opposite axis has 1 − cos at most (D + r − R)(D + r + R)/2rD. *)

let capped axis one_minus_cos =
  if one_minus_cos <= 0. then Nothing
  else if one_minus_cos < 2. then Cap { axis; one_minus_cos }
  else Whole

let part wall ~center ~radius:r =
  match wall.region with
  | Within { center = c; radius = size_of_wall } ->
      let way = Point.sub c center in
      let d = Vec.norm way in
      let more = slack (size_of_wall +. r +. d +. size c +. size center) in
      let near = size_of_wall -. d +. r +. more
      and far = size_of_wall +. d -. r +. more in
      if near <= 0. || far <= 0. then Nothing
      else capped (Dir.of_vec_or Dir.z way) (near /. r *. (far /. (2. *. d)))
  | Without { center = c; radius = size_of_wall } ->
      let way = Point.sub center c in
      let d = Vec.norm way in
      let more = slack (size_of_wall +. r +. d +. size c +. size center) in
      let near = d +. r -. size_of_wall +. more
      and far = d +. r +. size_of_wall in
      if near <= 0. then Nothing
      else capped (Dir.of_vec_or Dir.z way) (near /. r *. (far /. (2. *. d)))
  | Below { at; normal } ->
      let more = slack (r +. size at +. size center) in
      let near = r -. height at normal center +. more in
      capped (Dir.neg normal) (near /. r)

let left = function
  | Nothing -> 0.
  | Cap { one_minus_cos; _ } -> one_minus_cos
  | Whole -> 2.

let best t ~center ~radius =
  let least best wall =
    let part = part wall ~center ~radius in
    let before = match best with None -> 2. | Some (_, part) -> left part in
    if left part < before then Some (wall, part) else best
  in
  List.fold_left least None t

(* {1 Hulls of points} *)

let middle points =
  let b = Bounds.of_points points in
  let half x y = (0.5 *. x) +. (0.5 *. y) in
  Point.v (half b.x0 b.x1) (half b.y0 b.y1) (half b.z0 b.z1)

let hides points wall =
  match wall.region with
  | Within { center = c; radius = size_of_wall } ->
      let center = middle points in
      let reach p = distance p center in
      let radius =
        List.fold_left (fun r p -> Float.max r (reach p)) 0. points
      in
      let grown = Without { center = c; radius = size_of_wall +. radius } in
      depth grown center > 0.
  | Without { center; radius } ->
      let inside = Within { center; radius } in
      List.for_all (fun p -> depth inside p > 0.) points
  | Below { at; normal } ->
      let above = Below { at; normal = Dir.neg normal } in
      List.for_all (fun p -> depth above p > 0.) points

let beyond t points = List.find_opt (hides points) t

(* {1 The walls of a scene} *)

let opaque (m : Material.t) =
  match m.kind with
  | Glass _ | Translucent _ -> false
  | Matte _ | Phong _ | Mirror _ | Glazed _ | Metal _ | Plastic _ | Emitter ->
      true

let may_be_wall (shape : Primitives.shape) material =
  opaque material
  &&
  match shape with
  | Sphere _ | Box _ -> true
  | Triangle _ -> false
  | Quadric q -> (
      match (Quadric.shape q, Quadric.clip q) with
      | Plane _, None -> true
      | Plane _, Some _ -> false
      | ( ( Matrix _ | Form _ | Ellipsoid _ | Cylinder _ | Cone _ | Paraboloid _
          | Hyperbolic_paraboloid _ | Hyperboloid_one_sheet _
          | Hyperboloid_two_sheets _ ),
          _ ) ->
          false)

(* The plane through [at] with [normal], both as the primitive has them, and
   what is below it in the world. *)
let below (p : Primitives.t) at normal =
  let placed m =
    ( fst (Wide_affine.point (Transform.forward m) at Vec.zero),
      Affine.transposed (Transform.backward m).high normal )
  in
  let at, normal = Option.fold ~none:(at, normal) ~some:placed p.transform in
  match Dir.of_vec normal with
  | Some normal when Point.is_finite at -> Some (Below { at; normal })
  | Some _ | None -> None

let plane eye p normal offset =
  let unit = (Dir.of_vec_or Dir.z normal :> Vec.t) in
  let at =
    Point.add Point.origin (Vec.scale (offset /. Vec.norm normal) unit)
  in
  match (below p at normal, below p at (Vec.neg normal)) with
  | Some inside, Some outside ->
      if depth inside eye > 0. then [ (inside, Side.Inside) ]
      else [ (outside, Side.Outside) ]
  | None, _ | _, None -> []

let box eye p b =
  let low = Bounds.low b and high = Bounds.high b in
  let faces (axis : Dir.t) =
    [ below p low (Vec.neg (axis :> Vec.t)); below p high (axis :> Vec.t) ]
  in
  let faces = List.concat_map faces [ Dir.x; Dir.y; Dir.z ] in
  let around = function Some face -> depth face eye > 0. | None -> false in
  if List.for_all around faces then
    List.map (fun face -> (face, Side.Inside)) (List.filter_map Fun.id faces)
  else []

let sphere eye p =
  match Light_target.ball (Light_target.of_primitive p) with
  | None -> []
  | Some (center, radius) ->
      let within = Within { center; radius } in
      if depth within eye > 0. then [ (within, Side.Inside) ]
      else [ (Without { center; radius }, Side.Outside) ]

let walls eye (p : Primitives.t) =
  let sides =
    match p.shape with
    | Sphere _ -> sphere eye p
    | Box b -> box eye p (Box.bounds b)
    | Triangle _ -> []
    | Quadric q -> (
        match Quadric.shape q with
        | Plane { normal; offset } -> plane eye p normal offset
        | Matrix _ | Form _ | Ellipsoid _ | Cylinder _ | Cone _ | Paraboloid _
        | Hyperbolic_paraboloid _ | Hyperboloid_one_sheet _
        | Hyperboloid_two_sheets _ ->
            [])
  in
  List.map (fun (region, side) -> { region; path = p.path; side }) sides

(* Where rays start in the middle of the picture, or near it. *)
let eye (c : Camera.t) =
  let view = Dir.of_vec_or Dir.z (Point.sub c.look_at c.eye) in
  Point.along c.eye (view :> Vec.t) (Option.value c.near ~default:0.)

let around wall =
  match wall.region with Within _ | Below _ -> true | Without _ -> false

(* Every light asks all walls once, so there should not be too many. *)
let enough = 64

let of_scene (scene : Scene.t) =
  let still (p : Primitives.t) = Vec.equal p.velocity Vec.zero in
  let walls =
    Primitives.of_scene ~uses:false ~keep:may_be_wall scene
    |> List.filter still
    |> List.concat_map (walls (eye scene.camera))
  in
  let inner, outer = List.partition around walls in
  List.filteri (fun i _ -> i < enough) (inner @ outer)
