open Candor_space
open Candor_surface
open Candor_scene
open Candor_optics

let is_single (s : Scene.surface) =
  match s.shape with
  | Sphere _ | Box _ | Triangle _ | Quadric _ -> true
  | Polygon _ | Mesh _ | Group _ | Use _ -> false

let reflects scene surfaces =
  Assembly.materials_in_use { scene with Scene.surfaces }
  |> List.exists (fun (u : Assembly.use) -> Lobes.mirrors u.material)

(* The only surface of a scene that reflects, if it is none of several parts. *)
let only (scene : Scene.t) =
  let mirrors = Hashtbl.create 16 in
  List.iter
    (fun ({ name; value; _ } : _ Scene.named) ->
      Hashtbl.replace mirrors name (Lobes.mirrors value))
    scene.materials;
  let is_mirror (s : Scene.surface) =
    match s.material with
    | None -> false
    | Some (Inline m) -> Lobes.mirrors m
    | Some (Named name) ->
        Option.value (Hashtbl.find_opt mirrors name) ~default:false
  in
  let single, several = List.partition is_single scene.surfaces in
  match List.filter is_mirror single with
  | [ only ] when not (reflects scene several) -> Some only
  | [] | [ _ ] | _ :: _ :: _ -> None

let is_flat (b : Bounds.t) = b.x0 = b.x1 || b.y0 = b.y1 || b.z0 = b.z1

let is_plane q =
  match Quadric.shape q with
  | Plane _ -> true
  | Matrix _ | Form _ | Ellipsoid _ | Cylinder _ | Cone _ | Paraboloid _
  | Hyperbolic_paraboloid _ | Hyperboloid_one_sheet _ | Hyperboloid_two_sheets _
    ->
      false

let sees_only_from_outside (scene : Scene.t) (b : Bounds.t) =
  let { Point.x; y; z } = scene.camera.eye in
  let outside =
    x < b.x0 || b.x1 < x || y < b.y0 || b.y1 < y || z < b.z0 || b.z1 < z
  in
  let starts_at_eye =
    match scene.camera.frame with
    | Perspective_angle _ | Perspective_window _ | Panorama -> true
    | Orthographic_height _ | Orthographic_window _ -> false
  in
  outside && starts_at_eye
  && Option.is_none scene.camera.near
  && Option.is_none scene.camera.lens

let why (scene : Scene.t) =
  match only scene with
  | Some only when Scene.is_still only -> (
      let flat = Some "the only mirror is flat"
      and convex b =
        if sees_only_from_outside scene b then
          Some "the only mirror is convex and seen from outside"
        else None
      in
      match only.shape with
      | Triangle _ -> flat
      | Quadric q -> if is_plane q then flat else None
      | Box b ->
          let b = Box.bounds b in
          if is_flat b then flat else convex b
      | Sphere s -> convex (Sphere.bounds s)
      | Polygon _ | Mesh _ | Group _ | Use _ -> None)
  | Some _ | None -> None
