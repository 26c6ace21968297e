open Candor_surface
open Candor_scene

let name = "smooth normals"
let meaning = "triangles shade as the curved surface they stand for"
let is_smooth (t : Triangle.t) = Option.is_some t.normals

let smooth (s : Scene.surface) =
  match s.shape with
  | Triangle t when is_smooth t ->
      Some (Reason.v "triangle with normals" s.place)
  | Mesh { triangles; _ } when Array.exists is_smooth triangles ->
      Some (Reason.v "mesh with normals" s.place)
  | Triangle _ | Sphere _ | Box _ | Quadric _ | Polygon _ | Mesh _ | Group _
  | Use _ ->
      None

let calls scene = List.filter_map smooth (Assembly.surfaces_in_use scene)
