open Candor_space
open Candor_surface

type shape =
  | Sphere of Sphere.t
  | Box of Box.t
  | Triangle of Triangle.t
  | Quadric of Quadric.t

type t = {
  shape : shape;
  transform : Transform.t option;
  velocity : Vec.t;
  material : Material.t;
  both_sides : bool;
  path : int list;
  place : Place.t;
}

module Names = Map.Make (String)

let table entries =
  let add names (e : _ Scene.named) = Names.add e.name e.value names in
  List.fold_left add Names.empty entries

let resolve materials : Scene.material option -> Material.t = function
  | None -> Material.default
  | Some (Inline m) -> m
  | Some (Named name) ->
      Option.value (Names.find_opt name materials) ~default:Material.default

let composed steps =
  match steps with
  | [] -> None
  | _ :: _ -> Result.to_option (Transform.of_steps steps)

let after outer inner =
  match (outer, inner) with
  | None, one | one, None -> one
  | Some outer, Some inner -> Some (Transform.after outer inner)

let turned transform velocity =
  match transform with
  | None -> velocity
  | Some m -> Affine.vector (Transform.forward m).high velocity

(* What is in the group [s], member [index] of its parent, as the parent sees
   it. *)
let from_outside (s : Scene.surface) index transform p =
  {
    p with
    transform = after transform p.transform;
    velocity = Vec.add s.motion (turned transform p.velocity);
    both_sides = s.both_sides || p.both_sides;
    path = index :: p.path;
  }

let of_scene ?(uses = true) ~keep (scene : Scene.t) =
  let materials = table scene.materials
  and definitions = table scene.definitions in
  (* Local mutation: what has been found in definitions, by name and material
     given. *)
  let found = Hashtbl.create 16 in
  let primitive inherited (s : Scene.surface) path shape =
    let material = resolve materials inherited in
    if keep shape material then
      [
        {
          shape;
          transform = None;
          velocity = s.motion;
          material;
          both_sides = s.both_sides;
          path;
          place = s.place;
        };
      ]
    else []
  in
  let rec one inherited index (s : Scene.surface) =
    let inherited =
      if Option.is_some s.material then s.material else inherited
    in
    let primitive = primitive inherited s in
    let moved steps = List.map (from_outside s index (composed steps)) in
    match s.shape with
    | Sphere x -> primitive [ index ] (Sphere x)
    | Box x -> primitive [ index ] (Box x)
    | Triangle x -> primitive [ index ] (Triangle x)
    | Quadric x -> primitive [ index ] (Quadric x)
    | Polygon { triangles; _ } ->
        let part i x = primitive [ index; i ] (Triangle x) in
        List.concat (List.mapi part triangles)
    | Mesh { triangles; _ } ->
        let part i x = primitive [ index; i ] (Triangle x) in
        List.concat (List.mapi part (Array.to_list triangles))
    | Group { transform; surfaces } -> moved transform (all inherited surfaces)
    | Use { transform; name } ->
        if uses then moved transform (definition inherited name) else []
  and all inherited surfaces = List.concat (List.mapi (one inherited) surfaces)
  and definition inherited name =
    match Hashtbl.find_opt found (name, inherited) with
    | Some primitives -> primitives
    | None ->
        let surfaces =
          Option.value (Names.find_opt name definitions) ~default:[]
        in
        let primitives = all inherited surfaces in
        Hashtbl.add found (name, inherited) primitives;
        primitives
  in
  all None scene.surfaces
