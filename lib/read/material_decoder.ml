open Candor_scene
open Decode
open Fields
open Colour_decoder

let matte =
  let+ color = field "color" texture in
  Material.Matte { color }

let phong =
  let+ color = field "color" texture
  and+ specular = field "specular" reflectance
  and+ shininess = field "shininess" (Quantity.scalar "N" Rule.not_negative) in
  Material.Phong { color; specular; shininess }

let mirror =
  let+ color = default "color" texture (Constant Candor_colour.Rgb.white) in
  Material.Mirror { color }

let glazed =
  let+ color = field "color" texture and+ mirror = field "mirror" reflectance in
  Material.Glazed { color; mirror }

let material kind =
  fields
    (let+ material = kind and+ () = later [ "emission" ] in
     material)

let cases =
  [
    ("matte", material matte);
    ("phong", material phong);
    ("mirror", material mirror);
    ("glazed", material glazed);
  ]

let unbuilt = [ "glass"; "metal"; "plastic"; "translucent"; "emitter" ]

let definition =
  choice "material" ~later:unbuilt cases |> one "MATERIAL" |> named

let use =
  let inlined m = Scene.Inline m in
  let cases = List.map (fun (head, body) -> (head, map inlined body)) cases in
  let named name = Scene.Named name in
  choice "material"
    ~atom:(map_value named (reference Notes.Material))
    ~later:unbuilt cases
  |> one "MATERIAL"
