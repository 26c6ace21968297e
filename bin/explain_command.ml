open Cmdliner
open Candor_scene
open Candor_effect
open Candor_render

let place_of (r : Reason.t) = Place.to_string r.place

(* {1 For people} *)

let most_reasons = 6

let reasons rs =
  let shown = List.filteri (fun i _ -> i < most_reasons) rs in
  let line (r : Reason.t) =
    if Place.equal r.place Place.unknown then "      " ^ r.what
    else Printf.sprintf "      %s  [%s]" r.what (place_of r)
  in
  let more = List.length rs - List.length shown in
  List.map line shown
  @ if more > 0 then [ Printf.sprintf "      and %d more" more ] else []

let line name state says = Printf.sprintf "%-14s %-4s %s" name state says

let on_lines plan e =
  let head why = line (Effect.name e) "on" (Effect.meaning e ^ why) in
  match Plan.status plan e with
  | Called rs -> head "" :: reasons rs
  | Forced -> [ head "; nothing asks for it (--all-effects)" ]
  | Off -> []

let unshadowed plan (scene : Scene.t) =
  let free = List.filter (fun (l : Light.t) -> not l.shadows) scene.lights in
  if Plan.is_on plan Shadows && free <> [] then
    List.map
      (fun (l : Light.t) ->
        Printf.sprintf "      not for the light with (shadows no)  [%s]"
          (Place.to_string l.place))
      free
  else []

let depth_line plan =
  match Plan.depth plan with
  | Steps { most; why } ->
      line "depth" (string_of_int most)
        ("steps from surface to surface along one path at most: " ^ why)
  | Unbounded { why } -> line "depth" "none" why

let left_out scene =
  let of_surface (s : Scene.surface) =
    match s.shape with
    | Mesh { file; dropped; _ } when dropped > 0 ->
        let says = "faces without area in " ^ file in
        let place = Place.to_string s.place in
        Some
          (line "left out" (string_of_int dropped)
             (Printf.sprintf "%s  [%s]" says place))
    | Mesh _ | Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Group _
    | Use _ ->
        None
  in
  List.filter_map of_surface (Assembly.surfaces_in_use scene)

let finer plan scene : Effect.t -> string list = function
  | Shadows -> unshadowed plan scene
  | Emission | Ambient | Direct | Soft_shadows | Sky_light | Mirror | Refraction
  | Dispersion | Absorption | Subsurface | Gloss | Indirect | Fog
  | Depth_of_field | Motion_blur | Textures | Smooth_normals | Anti_aliasing ->
      []

let text plan scene =
  let on, off = List.partition (Plan.is_on plan) Effect.all in
  let off_line e =
    Printf.sprintf "  %-17s %s" (Effect.name e) (Effect.meaning e)
  in
  List.concat_map (fun e -> on_lines plan e @ finer plan scene e) on
  @ [ depth_line plan ]
  @ left_out scene
  @
  if off = [] then []
  else "off, since nothing in the scene asks for it:" :: List.map off_line off

(* {1 For programs} *)

let json_reason (r : Reason.t) =
  let place : (string * Json.t) list =
    if Place.equal r.place Place.unknown then []
    else
      [
        ("file", String r.place.file);
        ("line", Int r.place.line);
        ("column", Int r.place.column);
      ]
  in
  Json.Object (("what", String r.what) :: place)

let json_effect plan e =
  let why =
    match Plan.status plan e with Called rs -> rs | Forced | Off -> []
  in
  ( Effect.name e,
    Json.Object
      [
        ("on", Bool (Plan.is_on plan e));
        ("meaning", String (Effect.meaning e));
        ("why", List (List.map json_reason why));
      ] )

let json_depth plan : Json.t =
  match Plan.depth plan with
  | Steps { most; _ } -> Int most
  | Unbounded _ -> Null

let json plan =
  Json.Object
    [
      ("effects", Object (List.map (json_effect plan) Effect.all));
      ("depth", json_depth plan);
    ]

let run file settings all_effects as_json =
  match Settings.read file with
  | Error status -> status
  | Ok scene ->
      let scene = Settings.apply settings scene in
      let plan = Settings.plan ~all_effects scene in
      if as_json then print_string (Json.to_string (json plan))
      else List.iter print_endline (text plan scene);
      Fine

let as_json =
  Arg.(value & flag & info [ "json" ] ~doc:"Print the plan as JSON.")

let man =
  [
    `S Manpage.s_description;
    `P
      "Prints the plan: every effect that Candor knows, whether this scene \
       calls for it, and which line of the scene is the reason. What is off is \
       not compiled in: it traces no rays and allocates nothing.";
  ]

let command =
  Cmd.v
    (Cmd.info "explain" ~doc:"say which effects a scene calls for, and why" ~man
       ~exits:Status.infos)
    Cmdliner.Term.(
      const run $ Settings.scene $ Settings.term $ Settings.all_effects
      $ as_json)
