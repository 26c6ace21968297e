open Candor_space
open Candor_colour
open Candor_scene
open Candor_surface
open Candor_optics

let name = "direct light"
let meaning = "lights shine straight on surfaces"

let shines (l : Light.t) =
  match l.kind with
  | Point { intensity; _ } | Spot { intensity; _ } ->
      not (Rgb.is_black intensity)
  | Directional { irradiance; _ } -> not (Rgb.is_black irradiance)

let describe (l : Light.t) =
  match l.kind with
  | Point _ -> "point light"
  | Spot _ -> "spot light"
  | Directional _ -> "directional light"

let calls (scene : Scene.t) =
  let reason (l : Light.t) = Reason.v (describe l) l.place in
  if Reason.receivers scene = [] then []
  else List.map reason (List.filter shines scene.lights)

(* {1 On surfaces} *)

type shading = {
  is_dark : Lobes.t -> bool;
  outgoing : Lobes.t -> normal:Dir.t -> view:Vec.t -> Illumination.t -> Rgb.t;
}

let unit (normal : Dir.t) v = Dir.of_vec_or normal v

let highlight (h : Lobes.highlight) ~normal ~view ~toward irradiance =
  let toward = (unit normal toward :> Vec.t)
  and view = (unit normal view :> Vec.t) in
  let half = (unit normal (Vec.add toward view) :> Vec.t) in
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

let is_dark (lobes : Lobes.t) =
  Rgb.is_black lobes.diffuse && Option.is_none lobes.highlight

let matte = { is_dark; outgoing }

let glossy =
  {
    is_dark = (fun lobes -> is_dark lobes && Option.is_none lobes.gloss);
    outgoing =
      (fun lobes ~normal ~view light ->
        match lobes.gloss with
        | None -> outgoing lobes ~normal ~view light
        | Some gloss ->
            let toward = unit normal light.toward and view = unit normal view in
            let value = Gloss.value gloss ~normal ~view ~toward in
            Rgb.mul value light.irradiance);
  }

(* {1 What is between} *)

type reach = {
  surface : Tally.t -> Path.t -> Tracer.hit -> bool;
  space : Tally.t -> Path.t -> Point.t -> bool;
}

let always = { surface = (fun _ _ _ -> true); space = (fun _ _ _ -> true) }

type veil = Path.t -> Point.t -> Illumination.source -> Rgb.t
type lamp = { light : Light.t; reach : reach }

let veiled veil light : Path.t -> Point.t -> Rgb.t -> Rgb.t =
  match veil with
  | None -> fun _ _ irradiance -> irradiance
  | Some (veil : veil) ->
      let source = Illumination.source light in
      fun path point irradiance -> Rgb.mul (veil path point source) irradiance

(* {1 The sum} *)

let add_lamp shading veil { light; reach } =
  let shine = Illumination.compile light and veiled = veiled veil light in
  fun tally (v : Term.vertex) sum ->
    let lit = shine v.hit.point in
    if not (Hit.faces v.hit lit.toward) then (
      if Tally.watched tally then Tally.show tally (Faces_away { light });
      sum)
    else if
      Rgb.is_black lit.irradiance || not (reach.surface tally v.path v.hit)
    then sum
    else
      let irradiance = veiled v.path v.hit.point lit.irradiance in
      Rgb.add sum
        (shading.outgoing v.lobes ~normal:v.hit.shading_normal ~view:v.view
           { lit with irradiance })

let term shading ?veil lamps : Term.t =
  let lamps = Array.of_list (List.map (add_lamp shading veil) lamps) in
  fun _ tally vertex ->
    if shading.is_dark vertex.lobes then Rgb.black
    else Array.fold_left (fun sum add -> add tally vertex sum) Rgb.black lamps

let add_scattered veil { light; reach } =
  let shine = Illumination.compile light and veiled = veiled veil light in
  fun tally path (r : Receiver.t) sum ->
    let lit = shine r.vantage.from in
    if
      Rgb.is_black lit.irradiance || not (reach.space tally path r.vantage.from)
    then sum
    else
      let irradiance = veiled path r.vantage.from lit.irradiance in
      let toward = Dir.of_vec_or Dir.z lit.toward in
      Rgb.add sum (Rgb.mul (r.respond toward) irradiance)

type scattered = Tally.t -> Path.t -> Receiver.t -> Rgb.t

let scattered ?veil lamps : scattered =
  let lamps = Array.of_list (List.map (add_scattered veil) lamps) in
  fun tally path receiver ->
    Array.fold_left (fun sum add -> add tally path receiver sum) Rgb.black lamps
