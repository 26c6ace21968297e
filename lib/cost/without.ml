open Candor_colour
open Candor_scene
open Candor_surface
open Candor_effect

(* {1 Everywhere in a scene} *)

let rec within f (s : Scene.surface) =
  match s.shape with
  | Group { transform; surfaces } ->
      let surfaces = List.map (within f) surfaces in
      f { s with shape = Group { transform; surfaces } }
  | Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Mesh _ | Use _ ->
      f s

let map_surfaces f (scene : Scene.t) =
  let all = List.map (within f) in
  let definition (d : _ Scene.named) = { d with value = all d.value } in
  {
    scene with
    surfaces = all scene.surfaces;
    definitions = List.map definition scene.definitions;
  }

let map_materials f (scene : Scene.t) =
  let own : Scene.material -> Scene.material = function
    | Inline m -> Inline (f m)
    | Named _ as m -> m
  in
  let surface (s : Scene.surface) =
    { s with material = Option.map own s.material }
  and named (m : _ Scene.named) = { m with value = f m.value } in
  map_surfaces surface { scene with materials = List.map named scene.materials }

(* {1 Lights} *)

type light = { name : string; place : Place.t; dark : Scene.t }

let small (scene : Scene.t) =
  let without (l : Light.t) =
    List.filter (fun other -> other != l) scene.lights
  in
  let light (l : Light.t) =
    {
      name = Direct.describe l;
      place = l.place;
      dark = { scene with lights = without l };
    }
  in
  List.map light (List.filter Direct.shines scene.lights)

(* The places of emitters, each once, with the material of the first there. *)
let places emitters =
  let add met (e : Emitters.t) =
    match met with
    | (place, _) :: _ when Place.equal place e.place -> met
    | _ when List.exists (fun (p, _) -> Place.equal p e.place) met -> met
    | _ -> (e.place, e.material) :: met
  in
  List.rev (List.fold_left add [] emitters)

let large scene =
  let light (place, (material : Material.t)) =
    let dark = Scene.Inline { material with emission = Rgb.black } in
    let darken (s : Scene.surface) =
      if Place.equal s.place place then { s with material = Some dark } else s
    in
    { name = "area light"; place; dark = map_surfaces darken scene }
  in
  List.map light (places (Emitters.of_scene scene))

let ambient (scene : Scene.t) =
  match scene.ambient with
  | Some { value; place } when not (Rgb.is_black value) ->
      [
        { name = "ambient light"; place; dark = { scene with ambient = None } };
      ]
  | Some _ | None -> []

let is_black : Scene.background -> bool = function
  | Uniform c -> Rgb.is_black c
  | Gradient { down; up } -> Rgb.is_black down && Rgb.is_black up
  | Image { texels; _ } ->
      not (Texels.exists (fun c -> not (Rgb.is_black c)) texels)

let background (scene : Scene.t) =
  if is_black scene.background then []
  else
    let dark = { scene with background = Uniform Rgb.black } in
    [ { name = "background"; place = Place.unknown; dark } ]

let lights scene = small scene @ large scene @ ambient scene @ background scene

(* {1 What surfaces look like} *)

let mean a b = Rgb.scale 0.5 (Rgb.add a b)

let mean_texel texels =
  let width = Texels.width texels and height = Texels.height texels in
  let row y =
    List.fold_left
      (fun sum x -> Rgb.add sum (Texels.get texels x y))
      Rgb.black (List.init width Fun.id)
  in
  let sum =
    List.fold_left
      (fun sum y -> Rgb.add sum (row y))
      Rgb.black (List.init height Fun.id)
  in
  Rgb.scale (1. /. float_of_int (width * height)) sum

let rec mean_colour : Texture.t -> Rgb.t = function
  | Constant c -> c
  | Checker { even; odd; _ } -> mean (mean_colour even) (mean_colour odd)
  | Noise { first; second; _ } -> mean (mean_colour first) (mean_colour second)
  | Image { texels; _ } -> mean_texel texels

let plain (m : Material.t) =
  let flat t = Texture.Constant (mean_colour t) in
  let kind : Material.kind =
    match m.kind with
    | Matte { color } -> Matte { color = flat color }
    | Phong p -> Phong { p with color = flat p.color }
    | Mirror { color } -> Mirror { color = flat color }
    | Glazed g -> Glazed { g with color = flat g.color }
    | Glass g -> Glass { g with color = flat g.color }
    | Metal m -> Metal { m with reflectance = flat m.reflectance }
    | Plastic p -> Plastic { p with color = flat p.color }
    | (Translucent _ | Emitter) as kind -> kind
  in
  { m with kind }

let textures = map_materials plain

let faceted (t : Triangle.t) =
  Result.value (Triangle.make ?uv:t.uv t.corners) ~default:t

let smooth_normals =
  map_surfaces (fun (s : Scene.surface) ->
      match s.shape with
      | Triangle t -> { s with shape = Triangle (faceted t) }
      | Mesh m ->
          let triangles = Array.map faceted m.triangles in
          { s with shape = Mesh { m with triangles } }
      | Sphere _ | Box _ | Quadric _ | Polygon _ | Group _ | Use _ -> s)

(* {1 Effects} *)

let absent (e : Effect.t) scene =
  let as_planned scene = Some (scene, Plan.of_scene) in
  match e with
  | Textures -> as_planned (textures scene)
  | Smooth_normals -> as_planned (smooth_normals scene)
  | Anti_aliasing -> None
  | Emission | Ambient | Direct | Shadows | Soft_shadows | Sky_light | Mirror
  | Refraction | Dispersion | Absorption | Subsurface | Gloss | Indirect | Fog
  | Depth_of_field | Motion_blur ->
      Some (scene, Plan.without e)
