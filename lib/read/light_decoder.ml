open Candor_space
open Candor_scene
open Decode
open Fields
open Geometry_decoder

let falloff =
  let cases = [ ("none", Light.Constant) ] in
  default "falloff" (one "none" (word cases)) Light.Square

let shadows = default "shadows" (one "no" (word [ ("no", false) ])) true

let light kind =
  let light =
    let+ kind = kind and+ shadows = shadows in
    Result.map (fun kind place -> { Light.kind; shadows; place }) kind
  in
  fields light |> check Fun.id

let point =
  let+ at = field "at" point
  and+ intensity = field "intensity" Colour_decoder.light
  and+ falloff = falloff in
  Ok (Light.Point { at; intensity; falloff })

let directional =
  let+ direction = field "direction" direction
  and+ irradiance = field "irradiance" Colour_decoder.light in
  Ok (Light.Directional { direction; irradiance })

let spot =
  let angle = Quantity.scalar "DEG" (Rule.within 0. 90.) in
  let+ at = field "at" Geometry_decoder.point
  and+ toward = field "toward" Geometry_decoder.point
  and+ intensity = field "intensity" Colour_decoder.light
  and+ inner = field "inner" angle
  and+ outer = field "outer" angle
  and+ falloff = falloff in
  if Point.equal at toward then Error "at and toward are the same point"
  else if inner > outer then Error "inner must not be above outer"
  else Ok (Light.Spot { at; toward; intensity; inner; outer; falloff })

let light =
  choice "light"
    [
      ("point", light point);
      ("directional", light directional);
      ("spot", light spot);
    ]
  |> one "LIGHT" |> placed
