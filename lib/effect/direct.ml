open Candor_space
open Candor_colour
open Candor_scene
open Candor_surface
open Candor_optics

let name = "direct light"
let meaning = "lights shine straight on surfaces"

let black : Light.t -> bool =
 fun l ->
  match l.kind with
  | Point { intensity; _ } | Spot { intensity; _ } -> Rgb.is_black intensity
  | Directional { irradiance; _ } -> Rgb.is_black irradiance

let describe (l : Light.t) =
  match l.kind with
  | Point _ -> "point light"
  | Spot _ -> "spot light"
  | Directional _ -> "directional light"

let calls (scene : Scene.t) =
  if Reason.materials Lobes.diffuses scene = [] then []
  else
    List.filter (fun l -> not (black l)) scene.lights
    |> List.map (fun (l : Light.t) -> Reason.v (describe l) l.place)

type reach = Tally.t -> Assembly.skin Hit.t -> bool

let always _ _ = true

let highlight (h : Lobes.highlight) ~normal ~view ~toward irradiance =
  let unit v = (Dir.of_vec_or normal v :> Vec.t) in
  let half = unit (Vec.add (unit toward) (unit view)) in
  let cos = Float.max 0. (Vec.dot (normal : Dir.t :> Vec.t) half) in
  Rgb.mul h.specular (Rgb.scale (cos ** h.shininess) irradiance)

let outgoing (lobes : Lobes.t) ~normal ~view (light : Illumination.t) =
  let { Illumination.toward; irradiance } = light in
  let cos = Vec.dot (normal : Dir.t :> Vec.t) toward /. Vec.norm toward in
  if not (cos > 0.) then Rgb.black
  else
    let matte =
      Rgb.mul lobes.diffuse (Rgb.scale (cos /. Float.pi) irradiance)
    in
    match lobes.highlight with
    | None -> matte
    | Some h -> Rgb.add matte (highlight h ~normal ~view ~toward irradiance)

let faces (hit : _ Hit.t) toward =
  let ahead (n : Dir.t) = Vec.dot (n :> Vec.t) toward > 0. in
  ahead hit.normal && ahead hit.shading_normal

let add_light (light, reach) =
  let shine = Illumination.compile light in
  fun tally (v : Term.vertex) sum ->
    let lit = shine v.hit.point in
    if not (faces v.hit lit.toward) then (
      if Tally.watched tally then Tally.show tally (Faces_away { light });
      sum)
    else if Rgb.is_black lit.irradiance || not (reach tally v.hit) then sum
    else
      Rgb.add sum
        (outgoing v.lobes ~normal:v.hit.shading_normal ~view:v.view lit)

let dark (lobes : Lobes.t) =
  Rgb.is_black lobes.diffuse && Option.is_none lobes.highlight

let term lights : Term.t =
  let lights = Array.of_list (List.map add_light lights) in
  fun _ tally vertex ->
    if dark vertex.lobes then Rgb.black
    else Array.fold_left (fun sum add -> add tally vertex sum) Rgb.black lights
