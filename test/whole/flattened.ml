(** Every simple surface of a scene alone, in the same groups. *)

open Candor_scene

type leaf = { path : int list; alone : Scene.t }

(* [around] puts what it is given where the surface stood. *)
let rec one (scene : Scene.t) path around (s : Scene.surface) =
  let inside transform surfaces =
    let around s' =
      around { s with shape = Group { transform; surfaces = [ s' ] } }
    in
    List.concat
      (List.mapi (fun i s' -> one scene (i :: path) around s') surfaces)
  in
  match s.shape with
  | Sphere _ | Box _ | Triangle _ | Quadric _ ->
      let alone = { scene with surfaces = [ around s ] } in
      [ { path = List.rev path; alone } ]
  | Polygon { triangles; _ } ->
      inside [] (List.map (fun x -> { s with shape = Triangle x }) triangles)
  | Mesh { triangles; _ } ->
      let part x = { s with shape = Triangle x } in
      inside [] (List.map part (Array.to_list triangles))
  | Group { transform; surfaces } -> inside transform surfaces
  | Use { transform; name } ->
      let named (d : _ Scene.named) = String.equal d.name name in
      inside transform (List.find named scene.definitions).value

(** [leaves s] are the simple surfaces of [s] with their places. *)
let leaves (s : Scene.t) =
  List.concat (List.mapi (fun i x -> one s [ i ] Fun.id x) s.surfaces)
