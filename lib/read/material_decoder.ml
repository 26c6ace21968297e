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

(* Beyond these no dielectric is; within them no product overflows. *)
let index = field "index" (Quantity.scalar "N" (Rule.within 0.001 1000.))
let roughness = field "roughness" (Quantity.scalar "A" (Rule.within 0. 1.))

let anisotropy =
  default "anisotropy" (Quantity.scalar "G" (Rule.between (-1.) 1.)) 0.

let white = Texture.Constant Candor_colour.Rgb.white

let glass =
  let+ index = index
  and+ color = default "color" texture white
  and+ absorption = default "absorption" light Candor_colour.Rgb.black
  and+ dispersion =
    optional "dispersion" (Quantity.scalar "ABBE" Rule.above_zero)
  in
  Material.Glass { index; color; absorption; dispersion }

let metal =
  let+ reflectance = field "reflectance" texture and+ roughness = roughness in
  Material.Metal { reflectance; roughness }

let plastic =
  let+ color = field "color" texture
  and+ index = index
  and+ roughness = roughness in
  Material.Plastic { color; index; roughness }

let translucent =
  let+ index = index
  and+ scattering = field "scattering" light
  and+ absorption = field "absorption" light
  and+ anisotropy = anisotropy in
  Material.Translucent { index; scattering; absorption; anisotropy }

let material kind =
  let black = Candor_colour.Rgb.black in
  fields
    (let+ kind = kind and+ emission = default "emission" light black in
     { Material.kind; emission })

let emitter =
  fields
    (let+ emission = field "radiance" light in
     { Material.kind = Emitter; emission })

let cases =
  [
    ("matte", material matte);
    ("phong", material phong);
    ("mirror", material mirror);
    ("glazed", material glazed);
    ("glass", material glass);
    ("metal", material metal);
    ("plastic", material plastic);
    ("translucent", material translucent);
    ("emitter", emitter);
  ]

let definition = choice "material" cases |> one "MATERIAL" |> named

let use =
  let inlined m = Scene.Inline m in
  let cases = List.map (fun (head, body) -> (head, map inlined body)) cases in
  let named name = Scene.Named name in
  choice "material" ~atom:(map_value named (reference Notes.Material)) cases
  |> one "MATERIAL"
