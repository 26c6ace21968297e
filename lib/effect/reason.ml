open Candor_scene

type t = { what : string; place : Place.t } [@@deriving show, eq, ord]

let v what place = { what; place }

let kind : Material.t -> string = function
  | Matte _ -> "matte"
  | Phong _ -> "phong"
  | Mirror _ -> "mirror"
  | Glazed _ -> "glazed"

let of_use (u : Assembly.use) =
  match u.name with
  | Some name -> v ("material " ^ name) u.place
  | None -> v (kind u.material ^ " surface") u.place

let materials wanted scene =
  Assembly.materials_in_use scene
  |> List.filter (fun (u : Assembly.use) -> wanted u.material)
  |> List.map of_use
