open Candor_scene

let name = "depth of field"
let meaning = "what is not at the distance of focus is blurred"

let calls (scene : Scene.t) =
  match scene.camera.lens with
  | Some { radius; _ } when radius > 0. ->
      [ Reason.v "aperture of the camera" scene.camera.place ]
  | Some _ | None -> []

let lens (scene : Scene.t) =
  let point = { Camera.radius = 0.; focus = 1. } in
  Option.value scene.camera.lens ~default:point
