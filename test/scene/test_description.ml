open Candor_scene
open Candor_oracle
open Candor_scene_made

let defaults () =
  let { Scene.spp; depth; cutoff; seed; filter; error; time } =
    Scene.default_settings
  in
  Alcotest.(check (list int)) "spp, seed" [ 16; 0 ] [ spp; seed ];
  Alcotest.(check (option int)) "depth" None depth;
  Alcotest.(check (float 0.)) "cutoff" 0. cutoff;
  Alcotest.(check (list (option (float 0.))))
    "error, time" [ None; None ] [ error; time ];
  Alcotest.(check bool) "filter" true (filter = Box)

(* Whether any place but the unknown one is left anywhere. *)
let rec placeless (s : Scene.surface) =
  let inside =
    match s.shape with
    | Group { surfaces; _ } -> List.for_all placeless surfaces
    | Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Mesh _ | Use _ ->
        true
  in
  Place.equal s.place Place.unknown && inside

let unknown p = Place.equal p Place.unknown

let forgets (s : Scene.t) =
  let f = Scene.forget_places s in
  List.for_all placeless f.surfaces
  && List.for_all
       (fun (d : _ Scene.named) ->
         unknown d.place && List.for_all placeless d.value)
       f.definitions
  && List.for_all (fun (l : Light.t) -> unknown l.place) f.lights
  && List.for_all (fun (m : _ Scene.named) -> unknown m.place) f.materials
  && Option.fold ~none:true
       ~some:(fun (a : _ Scene.placed) -> unknown a.place)
       f.ambient
  && Scene.equal f (Scene.forget_places f)

let moved () =
  let text =
    [
      Written.flat_camera;
      "(group (sphere (center 0 0 0) (radius 1)))";
      "(ambient .1)";
    ]
  in
  let a = Written.scene text and b = Written.scene ("" :: "; lower" :: text) in
  Alcotest.(check bool) "places differ" false (Scene.equal a b);
  Alcotest.(check bool)
    "the scenes do not" true
    Scene.(equal (forget_places a) (forget_places b));
  let c =
    Written.scene
      (List.map
         (fun l -> if l = "(ambient .1)" then "(ambient .2)" else l)
         text)
  in
  Alcotest.(check bool)
    "another scene" false
    Scene.(equal (forget_places a) (forget_places c))

let depths () =
  let depth forms =
    Scene.depth (Written.scene (Written.flat_camera :: forms))
  in
  Alcotest.(check (list int))
    "depths" [ 8; 3; max_int; 3 ]
    [
      depth [];
      depth [ "(render (depth 3))" ];
      depth [ "(indirect-light)" ];
      depth [ "(indirect-light)"; "(render (depth 3))" ];
    ]

let reads_back s =
  match Candor_read.Scene_file.of_string ~name:"drawn.scene" (Drawn.show s) with
  | Ok s' -> Scene.(equal (forget_places s) (forget_places s'))
  | Error report ->
      Law.fail "%s" (Format.asprintf "%a" Candor_read.Error.pp_report report)

let suite =
  ( "scenes",
    [
      Law.example "defaults are those of the language" defaults;
      Law.law ~count:200 ~print:Drawn.show
        "forget_places leaves no place anywhere" (Drawn.scene Round) forgets;
      Law.example
        "paths end at depth 8, or under indirect light nowhere, unless told"
        depths;
      Law.law ~count:200 ~print:Drawn.show
        "scenes drawn of the whole language make sense, and read as printed"
        (Rich.scene Round) reads_back;
      Law.example "scenes written on other lines differ in places only" moved;
    ] )
