open Candor_space
open Candor_surface
module Names = Map.Make (String)

type skin = { material : Material.t; both_sides : bool; place : Place.t }

let table entries =
  let add t (e : _ Scene.named) = Names.add e.name e t in
  List.fold_left add Names.empty entries

let resolve materials : Scene.material -> Material.t = function
  | Inline m -> m
  | Named name -> (
      match Names.find_opt name materials with
      | Some (m : Material.t Scene.named) -> m.value
      | None -> Material.default)

let own_or inherited (s : Scene.surface) =
  match s.material with Some _ as own -> own | None -> inherited

let defined definitions name =
  match Names.find_opt name definitions with
  | Some (d : Scene.surface list Scene.named) -> d.value
  | None -> []

let transform steps =
  match steps with
  | [] -> None
  | _ :: _ -> Result.to_option (Transform.of_steps steps)

let surface ?math ~dress (scene : Scene.t) =
  let materials = table scene.materials
  and definitions = table scene.definitions in
  (* Local mutation: what has been shared so far, by name and what is inherited. *)
  let shared = Hashtbl.create 16 in
  let moving (s : Scene.surface) surface =
    if Scene.is_still s then surface
    else
      let { Camera.opens; closes } = scene.camera.shutter in
      Surface.moving ~velocity:s.motion ~shutter:(opens, closes) surface
  in
  let rec one inherited both (s : Scene.surface) =
    let inherited = own_or inherited s and both = both || s.both_sides in
    let material =
      Option.fold ~none:Material.default ~some:(resolve materials) inherited
    in
    let skin = dress { material; both_sides = both; place = s.place } in
    moving s
    @@
    match s.shape with
    | Sphere x -> Surface.sphere x skin
    | Box x -> Surface.box x skin
    | Triangle x -> Surface.triangle x skin
    | Quadric x -> Surface.quadric x skin
    | Polygon { triangles; _ } ->
        let part x = Surface.triangle x skin in
        Surface.group ?math (Array.of_list (List.map part triangles))
    | Mesh { triangles; _ } ->
        let part x = Surface.triangle x skin in
        Surface.group ?math (Array.map part triangles)
    | Group { transform = steps; surfaces } ->
        Surface.seen_through ?transform:(transform steps)
          (all inherited both surfaces)
    | Use { transform = steps; name } ->
        Surface.seen_through ?transform:(transform steps)
          (definition inherited both name)
  and all inherited both surfaces =
    Surface.group ?math
      (Array.map (one inherited both) (Array.of_list surfaces))
  and definition inherited both name =
    let key = (name, inherited, both) in
    match Hashtbl.find_opt shared key with
    | Some group -> group
    | None ->
        let group = all inherited both (defined definitions name) in
        Hashtbl.add shared key group;
        group
  in
  all None false scene.surfaces

type use = { name : string option; material : Material.t; place : Place.t }

let use_of materials place = function
  | None -> { name = None; material = Material.default; place }
  | Some (Scene.Inline material) -> { name = None; material; place }
  | Some (Named name as m) -> (
      let material = resolve materials m in
      match Names.find_opt name materials with
      | Some (n : Material.t Scene.named) ->
          { name = Some name; material; place = n.place }
      | None -> { name = Some name; material; place })

let materials_in_use (scene : Scene.t) =
  let materials = table scene.materials
  and definitions = table scene.definitions in
  (* Local mutation: the materials and definitions met so far. *)
  let met = Hashtbl.create 16 and entered = Hashtbl.create 16 in
  let uses = ref [] in
  let rec one inherited (s : Scene.surface) =
    let inherited = own_or inherited s in
    match s.shape with
    | Group { surfaces; _ } -> List.iter (one inherited) surfaces
    | Use { name; _ } ->
        if not (Hashtbl.mem entered (name, inherited)) then (
          Hashtbl.add entered (name, inherited) ();
          List.iter (one inherited) (defined definitions name))
    | Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Mesh _ ->
        if not (Hashtbl.mem met inherited) then (
          Hashtbl.add met inherited ();
          uses := use_of materials s.place inherited :: !uses)
  in
  List.iter (one None) scene.surfaces;
  List.rev !uses

let surfaces_in_use (scene : Scene.t) =
  let definitions = table scene.definitions in
  (* Local mutation: the definitions entered so far, and what was met. *)
  let entered = Hashtbl.create 16 and met = ref [] in
  let rec one (s : Scene.surface) =
    met := s :: !met;
    match s.shape with
    | Group { surfaces; _ } -> List.iter one surfaces
    | Use { name; _ } ->
        if not (Hashtbl.mem entered name) then (
          Hashtbl.add entered name ();
          List.iter one (defined definitions name))
    | Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Mesh _ -> ()
  in
  List.iter one scene.surfaces;
  List.rev !met
