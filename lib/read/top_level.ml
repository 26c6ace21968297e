open Candor_space
open Candor_scene
open Decode
module Names = Map.Make (String)

type origin = { notes : Notes.t; span : Span.t }

(* Lists hold the latest first. *)
type t = {
  image : int * int;
  camera : Camera.t option;
  background : Scene.background;
  ambient : Candor_colour.Rgb.t Scene.placed option;
  indirect : Place.t option;
  fog : Scene.fog Scene.placed option;
  settings : Scene.settings;
  lights : Light.t list;
  materials : Material.t Scene.named list;
  definitions : Scene.surface list Scene.named list;
  surfaces : Scene.surface list;
  given : origin Names.t;  (** forms that may stand only once *)
  material_names : origin Names.t;
  definition_names : origin Names.t;
}

let empty =
  {
    image = (640, 480);
    camera = None;
    background = Uniform Candor_colour.Rgb.black;
    ambient = None;
    indirect = None;
    fog = None;
    settings = Scene.default_settings;
    lights = [];
    materials = [];
    definitions = [];
    surfaces = [];
    given = Names.empty;
    material_names = Names.empty;
    definition_names = Names.empty;
  }

(* {1 Forms} *)

(* [first origin message name names] is [names] with [name], or an error if it
   is there already. *)
let first origin message name names =
  match Names.find_opt name names with
  | None -> Some (Names.add name origin names)
  | Some before ->
      let place o = Notes.place o.notes o.span in
      let hint =
        if Place.equal (place before) (place origin) then
          "this file is included twice"
        else "the first is at " ^ Place.to_string (place before)
      in
      Notes.refuse origin.notes origin.span message ~hint

let many b add =
  body (arguments b) (fun notes form -> Option.map add (read_body b notes form))

let once b add =
  let read notes (form : Form.t) =
    let value = read_body b notes form in
    let message = Form.title form.head ^ " is given twice" in
    let add t =
      match first { notes; span = form.span } message form.head t.given with
      | None -> t
      | Some given ->
          let t = { t with given } in
          Option.fold value ~none:t ~some:(fun value -> add value t)
    in
    Some add
  in
  body (arguments b) read

(* A definition of a name whose value could not be read still defines it. *)
let definition b noun ~names ~add =
  let read notes form =
    let define (name, span, value) t =
      let message =
        Printf.sprintf "%s %s is defined twice" noun (Quote.word name)
      in
      match first { notes; span } message name (names t) with
      | None -> t
      | Some names ->
          let place = Notes.place notes form.Form.span in
          let named value = { Scene.name; value; place } in
          add names (Option.map named value) t
    in
    Option.map define (read_body b notes form)
  in
  body (arguments b) read

let cons option list = Option.fold option ~none:list ~some:(fun x -> x :: list)

let material =
  definition Material_decoder.definition "material"
    ~names:(fun t -> t.material_names)
    ~add:(fun material_names m t ->
      { t with material_names; materials = cons m t.materials })

let define =
  definition Surface_decoder.definition "definition"
    ~names:(fun t -> t.definition_names)
    ~add:(fun definition_names d t ->
      { t with definition_names; definitions = cons d t.definitions })

let ambient =
  Colour_decoder.light
  |> map (fun value place -> { Scene.value; place })
  |> placed

let surface (head, b) =
  (head, many b (fun s t -> { t with surfaces = s :: t.surfaces }))

let inclusion include_ =
  let file = one "FILE" name in
  body "FILE" (fun notes form ->
      let add (path, span) t = include_ notes span path t in
      Option.map add (read_body file notes form))

let form ~include_ =
  choice "form"
    ([
       ("image", once Setting_decoder.image (fun image t -> { t with image }));
       ( "camera",
         once Camera_decoder.camera (fun c t -> { t with camera = Some c }) );
       ( "background",
         once Setting_decoder.background (fun background t ->
             { t with background }) );
       ("ambient", once ambient (fun a t -> { t with ambient = Some a }));
       ( "indirect-light",
         once Setting_decoder.indirect (fun place t ->
             { t with indirect = Some place }) );
       ("fog", once Setting_decoder.fog (fun f t -> { t with fog = Some f }));
       ( "render",
         once Setting_decoder.render (fun settings t -> { t with settings }) );
       ( "light",
         many Light_decoder.light (fun l t -> { t with lights = l :: t.lights })
       );
       ("material", material);
       ("define", define);
       ("include", inclusion include_);
     ]
    @ List.map surface Surface_decoder.cases)

(* {1 The whole} *)

let rec uses used (s : Scene.surface) =
  match s.shape with
  | Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Mesh _ -> used
  | Use { name; _ } -> name :: used
  | Group { surfaces; _ } -> List.fold_left uses used surfaces

let check_cycles t =
  let edge (d : _ Scene.named) = (d.name, List.fold_left uses [] d.value) in
  let refuse cycle { notes; span } =
    Notes.error notes span ("a definition contains itself: " ^ Quote.chain cycle)
  in
  let origin name = Names.find_opt name t.definition_names in
  let check cycle =
    Option.iter (refuse cycle) (Option.bind (List.nth_opt cycle 0) origin)
  in
  List.iter check (Cycles.all (List.rev_map edge t.definitions))

let check_camera notes span t =
  if not (Names.mem "camera" t.given) then
    Notes.error notes span "the scene has no camera"
      ~hint:"add (camera (perspective (eye 0 1 5) (look-at 0 1 0) (fov-y 40)))"

let check_names notes t =
  let check_mentions kind names =
    Notes.check_mentions notes kind
      ~is_known:(fun name -> Names.mem name names)
      ~known:(List.map fst (Names.bindings names))
  in
  check_mentions Material t.material_names;
  check_mentions Definition t.definition_names

(* Stands in for a camera that is missing or wrong, so that what is wrong with
   the rest is told all the same. *)
let no_camera =
  {
    Camera.eye = Point.origin;
    look_at = Point.v 0. 0. (-1.);
    up = Vec.v 0. 1. 0.;
    frame = Panorama;
    near = None;
    lens = None;
    shutter = Camera.instant;
    place = Place.unknown;
  }

let scene t =
  let width, height = t.image in
  {
    Scene.width;
    height;
    camera = Option.value t.camera ~default:no_camera;
    background = t.background;
    ambient = t.ambient;
    indirect = t.indirect;
    fog = t.fog;
    settings = t.settings;
    lights = List.rev t.lights;
    materials = List.rev t.materials;
    definitions = List.rev t.definitions;
    surfaces = List.rev t.surfaces;
  }

let finish notes span t =
  let scene = scene t in
  if not (Notes.incomplete notes) then (
    check_names notes t;
    check_cycles t;
    check_camera notes span t;
    Sense.check notes scene);
  if Notes.is_clean notes then Some scene else None
