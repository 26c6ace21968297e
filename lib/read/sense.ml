open Candor_space
open Candor_colour
open Candor_scene
module Names = Map.Make (String)

let is_at place = "is at " ^ Place.to_string place

(* {1 Light} *)

let ambient notes (scene : Scene.t) =
  match (scene.ambient, scene.indirect) with
  | Some ambient, Some indirect ->
      Notes.error_at notes ambient.place
        "(ambient ...) stands in for what (indirect-light) simulates: give one"
        ~hint:("(indirect-light) " ^ is_at indirect)
  | None, _ | _, None -> ()

let is_black (b : Scene.background) =
  match b with
  | Uniform c -> Rgb.is_black c
  | Gradient { down; up } -> Rgb.is_black down && Rgb.is_black up
  | Image { texels; _ } ->
      not (Texels.exists (fun c -> not (Rgb.is_black c)) texels)

let endless_fog notes (scene : Scene.t) place =
  let error = Notes.error_at notes in
  let bound = "(within (min X Y Z) (max X Y Z))" in
  let light (l : Light.t) =
    match l.kind with
    | Point _ | Spot _ -> ()
    | Directional _ ->
        error l.place "fog without bounds leaves nothing of a directional light"
          ~hint:(Printf.sprintf "the fog %s: give it %s" (is_at place) bound)
  in
  List.iter light scene.lights;
  if not (is_black scene.background) then
    error place "fog without bounds leaves nothing of the background"
      ~hint:(Printf.sprintf "give it %s, or make the background black" bound)

let fog notes (scene : Scene.t) =
  match scene.fog with
  | Some { value = { within = None; _ }; place } ->
      endless_fog notes scene place
  | Some { value = { within = Some _; _ }; _ } | None -> ()

(* {1 Materials on surfaces} *)

(* A material, with the form that gives it. *)
type given = { material : Material.t; place : Place.t }

type state = {
  notes : Notes.t;
  indirect : Place.t option;
  shutter : Camera.shutter;
  materials : Material.t Scene.named Names.t;
  definitions : Scene.surface list Scene.named Names.t;
  (* Local mutation: what has been looked at, by name. *)
  judged : (string, unit) Hashtbl.t;  (** materials *)
  entered : (string, unit) Hashtbl.t;  (** definitions in use *)
  lacking : (string, Scene.surface list) Hashtbl.t;
      (** in each definition the first for each lack, of the surfaces that take
          their material from where it is used *)
}

let once table name f =
  if not (Hashtbl.mem table name) then (
    Hashtbl.add table name ();
    f ())

(* Under indirect light. *)
let check_energy t { material; place } indirect =
  let error message hint =
    let hint = hint ^ "(indirect-light) " ^ is_at indirect in
    Notes.error_at t.notes place message ~hint
  in
  match material.kind with
  | Phong _ ->
      error "phong may return more light than it gets: not with indirect light"
        "use plastic; "
  | Glazed { color; mirror = m } ->
      let exceeds (c : Rgb.t) =
        c.r +. m.r > 1. || c.g +. m.g > 1. || c.b +. m.b > 1.
      in
      if Texture.exists exceeds color then
        error "color + mirror must be at most 1 with indirect light" ""
  | Matte _ | Mirror _ | Glass _ | Metal _ | Plastic _ | Translucent _ | Emitter
    ->
      ()

let judge t given = Option.iter (check_energy t given) t.indirect

let own t (s : Scene.surface) =
  match s.material with
  | None -> None
  | Some (Inline material) ->
      let given = { material; place = s.place } in
      judge t given;
      Some given
  | Some (Named name) ->
      let given (m : _ Scene.named) =
        let given = { material = m.value; place = m.place } in
        once t.judged name (fun () -> judge t given);
        given
      in
      Option.map given (Names.find_opt name t.materials)

let defined t name =
  let value (d : _ Scene.named) = d.value in
  Option.fold (Names.find_opt name t.definitions) ~none:[] ~some:value

let first_for_each surfaces =
  let first lack =
    List.find_opt
      (fun (s : Scene.surface) -> Lack.is_of ~grouped:true s.shape lack)
      surfaces
  in
  List.filter_map first Lack.all

(* In a cycle a definition adds nothing to itself. *)
let rec lacking t name =
  match Hashtbl.find_opt t.lacking name with
  | Some surfaces -> surfaces
  | None ->
      Hashtbl.add t.lacking name [];
      let surfaces = lacking_among t (defined t name) in
      Hashtbl.replace t.lacking name surfaces;
      surfaces

and lacking_among t surfaces =
  let parts (s : Scene.surface) =
    match (s.material, s.shape) with
    | Some _, _ -> []
    | None, Group { surfaces; _ } -> lacking_among t surfaces
    | None, Use { name; _ } -> lacking t name
    | None, (Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Mesh _) ->
        [ s ]
  in
  first_for_each (List.concat_map parts surfaces)

(* {1 Surfaces} *)

let check_lacks t ~grouped given (s : Scene.surface) =
  let source =
    if Place.equal given.place s.place then ""
    else "; its material " ^ is_at given.place
  in
  let check lack =
    if Lack.is_of ~grouped s.shape lack && Lack.is_minded_by given.material lack
    then
      let hint = Lack.advice lack s.shape ^ source in
      Notes.error_at t.notes s.place (Lack.complaint lack) ~hint
  in
  List.iter check Lack.all

let check_motion t (s : Scene.surface) =
  let { Camera.opens; closes } = t.shutter in
  let longest = Float.max (Float.abs opens) (Float.abs closes) in
  if longest *. Vec.largest s.motion > 0x1p400 then
    Notes.error_at t.notes s.place
      "this moves farther than 2^400 while the shutter is open"

let rec surface t ~grouped around (s : Scene.surface) =
  check_motion t s;
  let given = match s.material with None -> around | Some _ -> own t s in
  match s.shape with
  | Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Mesh _ ->
      Option.iter (fun given -> check_lacks t ~grouped given s) given
  | Group { surfaces; _ } -> List.iter (surface t ~grouped:true given) surfaces
  | Use { name; _ } ->
      let check given =
        List.iter (check_lacks t ~grouped:true given) (lacking t name)
      in
      Option.iter check given;
      once t.entered name (fun () ->
          List.iter (surface t ~grouped:true None) (defined t name))

let named list =
  let entry (n : _ Scene.named) = (n.name, n) in
  Names.of_seq (Seq.map entry (List.to_seq list))

let surfaces notes (scene : Scene.t) =
  let state =
    {
      notes;
      indirect = scene.indirect;
      shutter = scene.camera.shutter;
      materials = named scene.materials;
      definitions = named scene.definitions;
      judged = Hashtbl.create 16;
      entered = Hashtbl.create 16;
      lacking = Hashtbl.create 16;
    }
  in
  List.iter (surface state ~grouped:false None) scene.surfaces

let check notes scene =
  ambient notes scene;
  fog notes scene;
  surfaces notes scene
