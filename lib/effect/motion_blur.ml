open Candor_scene

let name = "motion blur"
let meaning = "what moves while the shutter is open is smeared"

let moving (s : Scene.surface) =
  if Scene.is_still s then None else Some (Reason.v "motion" s.place)

let calls (scene : Scene.t) =
  let { Camera.opens; closes } = scene.camera.shutter in
  if opens = 0. && closes = 0. then []
  else List.filter_map moving (Assembly.surfaces_in_use scene)

let time (scene : Scene.t) u =
  let { Camera.opens; closes } = scene.camera.shutter in
  opens +. ((closes -. opens) *. u)
