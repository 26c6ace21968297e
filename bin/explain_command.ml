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
    Printf.sprintf "      %s  [%s]" r.what (place_of r)
  in
  let more = List.length rs - List.length shown in
  List.map line shown
  @ if more > 0 then [ Printf.sprintf "      and %d more" more ] else []

let effect_lines plan e =
  let head state why =
    Printf.sprintf "%-13s %-4s %s%s" (Effect.name e) state (Effect.meaning e)
      why
  in
  match Plan.status plan e with
  | Called rs -> head "on" "" :: reasons rs
  | Forced -> [ head "on" "; nothing asks for it (--all-effects)" ]
  | Off -> [ head "off" "; nothing in the scene asks for it" ]

let unshadowed plan (scene : Scene.t) =
  let free = List.filter (fun (l : Light.t) -> not l.shadows) scene.lights in
  if Plan.is_on plan Shadows && free <> [] then
    List.map
      (fun (l : Light.t) ->
        Printf.sprintf "      not for the light with (shadows no)  [%s]"
          (Place.to_string l.place))
      free
  else []

let depth_line plan (scene : Scene.t) =
  let why =
    if Plan.depth plan = 0 && scene.settings.depth > 0 then "nothing reflects"
    else "the scene's limit"
  in
  Printf.sprintf "%-13s %-4d reflections along one path at most: %s" "depth"
    (Plan.depth plan) why

let text plan scene =
  let lines e =
    effect_lines plan e
    @
    match (e : Effect.t) with
    | Shadows -> unshadowed plan scene
    | Ambient | Direct | Mirror -> []
  in
  List.concat_map lines Effect.all @ [ depth_line plan scene ]

(* {1 For programs} *)

let json_reason (r : Reason.t) =
  Json.Object
    [
      ("what", String r.what);
      ("file", String r.place.file);
      ("line", Int r.place.line);
      ("column", Int r.place.column);
    ]

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

let json plan =
  Json.Object
    [
      ("effects", Object (List.map (json_effect plan) Effect.all));
      ("depth", Int (Plan.depth plan));
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
