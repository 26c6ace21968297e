open Candor_space
open Candor_colour
open Candor_surface

type background =
  | Uniform of Rgb.t
  | Gradient of { down : Rgb.t; up : Rgb.t }
  | Image of { file : string; texels : Texels.t }
[@@deriving show, eq, ord]

type filter = Box | Tent [@@deriving show, eq, ord]

type settings = {
  spp : int;
  depth : int option;
  cutoff : float;
  seed : int;
  filter : filter;
  error : float option;
  time : float option;
}
[@@deriving show, eq, ord]

type material = Named of string | Inline of Material.t
[@@deriving show, eq, ord]

type surface = {
  shape : shape;
  material : material option;
  motion : Vec.t;
  both_sides : bool;
  place : Place.t;
}

and shape =
  | Sphere of Sphere.t
  | Box of Box.t
  | Triangle of Triangle.t
  | Quadric of Quadric.t
  | Polygon of Polygon.t
  | Mesh of {
      file : string;
      triangles : (Triangle.t array[@opaque]);
      dropped : int;
    }
  | Group of { transform : Transform.step list; surfaces : surface list }
  | Use of { transform : Transform.step list; name : string }
[@@deriving show, eq]

type 'a named = { name : string; value : 'a; place : Place.t }
[@@deriving show, eq]

type 'a placed = { value : 'a; place : Place.t } [@@deriving show, eq]

type fog = {
  extinction : Rgb.t;
  albedo : Rgb.t;
  anisotropy : float;
  within : Bounds.t option;
}
[@@deriving show, eq]

type t = {
  width : int;
  height : int;
  camera : Camera.t;
  background : background;
  ambient : Rgb.t placed option;
  indirect : Place.t option;
  fog : fog placed option;
  settings : settings;
  lights : Light.t list;
  materials : Material.t named list;
  definitions : surface list named list;
  surfaces : surface list;
}
[@@deriving show, eq]

let default_settings =
  {
    spp = 16;
    depth = None;
    cutoff = 0.;
    seed = 0;
    filter = Box;
    error = None;
    time = None;
  }

let most_samples = 0x40000000

let plain shape place =
  { shape; material = None; motion = Vec.zero; both_sides = false; place }

let depth s =
  let unlimited = if Option.is_some s.indirect then max_int else 8 in
  Option.value s.settings.depth ~default:unlimited

let is_still s = Vec.equal s.motion Vec.zero

let rec forget_surface (s : surface) =
  let shape =
    match s.shape with
    | (Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Mesh _ | Use _)
      as shape ->
        shape
    | Group { transform; surfaces } ->
        Group { transform; surfaces = List.map forget_surface surfaces }
  in
  { s with shape; place = Place.unknown }

let forget_named value (n : _ named) =
  { n with value = value n.value; place = Place.unknown }

let forget_places s =
  let light (l : Light.t) = { l with place = Place.unknown } in
  let placed p = { p with place = Place.unknown } in
  {
    s with
    camera = { s.camera with place = Place.unknown };
    ambient = Option.map placed s.ambient;
    indirect = Option.map (fun _ -> Place.unknown) s.indirect;
    fog = Option.map placed s.fog;
    lights = List.map light s.lights;
    materials = List.map (forget_named Fun.id) s.materials;
    definitions =
      List.map (forget_named (List.map forget_surface)) s.definitions;
    surfaces = List.map forget_surface s.surfaces;
  }
