open Candor_scene

type t = { what : string; place : Place.t } [@@deriving show, eq, ord]

let v what place = { what; place }

let kind (m : Material.t) =
  match m.kind with
  | Matte _ -> "matte"
  | Phong _ -> "phong"
  | Mirror _ -> "mirror"
  | Glazed _ -> "glazed"
  | Glass _ -> "glass"
  | Metal _ -> "metal"
  | Plastic _ -> "plastic"
  | Translucent _ -> "translucent"
  | Emitter -> "emitting"

let of_use (u : Assembly.use) =
  match u.name with
  | Some name -> v ("material " ^ name) u.place
  | None -> v (kind u.material ^ " surface") u.place

let materials wanted scene =
  Assembly.materials_in_use scene
  |> List.filter (fun (u : Assembly.use) -> wanted u.material)
  |> List.map of_use

let scatters (fog : Scene.fog Scene.placed) =
  let { Scene.extinction; albedo; _ } = fog.value in
  not (Candor_colour.Rgb.is_black (Candor_colour.Rgb.mul extinction albedo))

let fog (scene : Scene.t) =
  match scene.fog with
  | Some fog when scatters fog -> [ v "fog" fog.place ]
  | Some _ | None -> []

let is_cloudy (m : Material.t) =
  match m.kind with
  | Translucent { scattering; _ } -> not (Candor_colour.Rgb.is_black scattering)
  | Matte _ | Phong _ | Mirror _ | Glazed _ | Glass _ | Metal _ | Plastic _
  | Emitter ->
      false

let receivers scene =
  let shows m = Candor_optics.Lobes.responds m || is_cloudy m in
  materials shows scene @ fog scene
