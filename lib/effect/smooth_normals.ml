open Candor_surface
open Candor_scene

let name = "smooth normals"
let meaning = "triangles shade as the curved surface they stand for"

let smooth (s : Scene.surface) =
  match s.shape with
  | Triangle t when Option.is_some t.Triangle.normals ->
      Some (Reason.v "triangle with normals" s.place)
  | Triangle _ | Sphere _ | Box _ | Quadric _ | Polygon _ | Group _ | Use _ ->
      None

let calls scene = List.filter_map smooth (Assembly.surfaces_in_use scene)
