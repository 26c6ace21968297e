open Candor_colour
open Candor_scene
open Candor_optics

let name = "ambient"
let meaning = "a constant stands in for light that bounces"
let matte m = Lobes.diffuses m

let calls (scene : Scene.t) =
  match scene.ambient with
  | Some { value; place } when not (Rgb.is_black value) ->
      if Reason.materials matte scene = [] then []
      else [ Reason.v "ambient light" place ]
  | Some _ | None -> []

let term light : Term.t = fun _ _ vertex -> Rgb.mul vertex.lobes.diffuse light
