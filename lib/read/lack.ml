open Candor_space
open Candor_surface
open Candor_scene

type t = Bounds | Inside | Uv

let all = [ Bounds; Inside; Uv ]

(* Whether all eigenvalues of the symmetric 3×3 matrix have one sign, by the
   pivots of its elimination. *)
let is_definite xx xy xz yy yz zz =
  let yy = yy -. (xy *. (xy /. xx)) and yz = yz -. (xy *. (xz /. xx)) in
  let zz = zz -. (xz *. (xz /. xx)) -. (yz *. (yz /. yy)) in
  (xx > 0. && yy > 0. && zz > 0.) || (xx < 0. && yy < 0. && zz < 0.)

let closes_up q =
  Option.is_none (Quadric.clip q)
  &&
  match Quadric.shape q with
  | Ellipsoid _ -> true
  | Cylinder _ | Cone _ | Paraboloid _ -> Quadric.caps q
  | Matrix m -> is_definite m.(0) m.(1) m.(2) m.(5) m.(6) m.(10)
  | Form { a; _ } -> is_definite a.(0) a.(1) a.(2) a.(4) a.(5) a.(8)
  | Plane _ | Hyperbolic_paraboloid _ | Hyperboloid_one_sheet _
  | Hyperboloid_two_sheets _ ->
      false

let has_uv q =
  match Quadric.shape q with
  | Plane _ | Cylinder _ | Cone _ | Paraboloid _ -> true
  | Matrix _ | Form _ | Ellipsoid _ | Hyperbolic_paraboloid _
  | Hyperboloid_one_sheet _ | Hyperboloid_two_sheets _ ->
      false

let is_thick (b : Box.t) =
  let b = (b :> Bounds.t) in
  b.x0 < b.x1 && b.y0 < b.y1 && b.z0 < b.z1

let is_of ~grouped (shape : Scene.shape) lack =
  match (lack, shape) with
  | Bounds, Quadric q -> not (Bounds.is_finite (Quadric.bounds q))
  | Inside, Quadric q -> not (closes_up q)
  | Uv, Quadric q -> not (has_uv q)
  | Inside, Box b -> not (is_thick b)
  | Inside, (Triangle _ | Polygon _) -> not grouped
  | Inside, (Sphere _ | Mesh _ | Group _ | Use _)
  | ( (Bounds | Uv),
      (Sphere _ | Box _ | Triangle _ | Polygon _ | Mesh _ | Group _ | Use _) )
    ->
      false

let rec has_image : Texture.t -> bool = function
  | Image _ -> true
  | Constant _ -> false
  | Checker { even = a; odd = b; _ } | Noise { first = a; second = b; _ } ->
      has_image a || has_image b

let is_minded_by (m : Material.t) lack =
  match (lack, m.kind) with
  | Bounds, _ -> Material.emits m
  | Inside, Translucent _ -> true
  | Uv, (Matte { color } | Phong { color; _ } | Mirror { color })
  | Uv, (Glazed { color; _ } | Glass { color; _ } | Plastic { color; _ })
  | Uv, Metal { reflectance = color; _ } ->
      has_image color
  | Uv, (Translucent _ | Emitter) -> false
  | ( Inside,
      ( Matte _ | Phong _ | Mirror _ | Glazed _ | Glass _ | Metal _ | Plastic _
      | Emitter ) ) ->
      false

let complaint = function
  | Bounds -> "a surface without bounds may not emit light"
  | Inside -> "a translucent surface must be closed"
  | Uv -> "this surface has no uv for an image"

let advice lack (shape : Scene.shape) =
  match (lack, shape) with
  | Bounds, _ -> "cut it with (clip (min X Y Z) (max X Y Z))"
  | Inside, (Triangle _ | Polygon _) ->
      "put all that closes it into one (group ...)"
  | Inside, Quadric q
    when Option.is_none (Quadric.clip q)
         && Option.is_some (Quadric_shape.ends (Quadric.shape q)) ->
      "add (caps)"
  | Inside, (Sphere _ | Box _ | Quadric _ | Mesh _ | Group _ | Use _) ->
      "closed are spheres, boxes that are not flat, and ellipsoids, cylinders, \
       cones and paraboloids with (caps) and without (clip ...)"
  | Uv, _ -> "of quadrics, planes, cylinders, cones and paraboloids have"
