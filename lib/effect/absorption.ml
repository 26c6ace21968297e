open Candor_colour
open Candor_scene
open Candor_optics

let name = "absorption"
let meaning = "coloured glass takes light away on its way"

let glass (m : Material.t) =
  match m.kind with
  | Glass _ -> Medium.of_material m
  | Matte _ | Phong _ | Mirror _ | Glazed _ | Metal _ | Plastic _
  | Translucent _ | Emitter ->
      None

let calls = Reason.materials (fun m -> Option.is_some (glass m))

let segment : Segment.t =
 fun _ _ path ray hit arrive ->
  match path.journey.inside with
  | [] -> arrive path ray hit
  | top :: _ -> (
      match glass top with
      | None -> arrive path ray hit
      | Some medium ->
          let share = Medium.transmittance medium (Segment.length ray hit) in
          Segment.weighted share path ray hit arrive)

let veil (path : Path.t) point source =
  match path.journey.inside with
  | [] -> Rgb.white
  | top :: _ -> (
      match Medium.of_material top with
      | None -> Rgb.white
      | Some medium ->
          Medium.transmittance medium (Segment.distance point source))
