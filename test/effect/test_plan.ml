open Candor_scene
open Candor_effect
open Candor_oracle
open Candor_scene_made

let ball ?(material = "") () =
  Printf.sprintf "(sphere (center 0 0 0) (radius 1) %s)" material

let matte = ball ~material:"(material (matte (color .5)))" ()
let black = ball ~material:"(material (matte (color 0)))" ()
let mirror = ball ~material:"(material (mirror))" ()
let point = "(light (point (at 5 5 5) (intensity 100)))"
let unshadowed = "(light (point (at 5 5 5) (intensity 100) (shadows no)))"
let unlit = "(light (point (at 5 5 5) (intensity 0)))"

let status plan e =
  match Plan.status plan e with
  | Off -> "off"
  | Forced -> "forced"
  | Called reasons -> String.concat "; " (Test_reason.written reasons)

let statuses plan = List.map (status plan) Effect.all

let check name forms expected =
  let plan = Plan.of_scene (Lit.scene forms) in
  Alcotest.(check (list string)) name expected (statuses plan);
  List.iter2
    (fun e s ->
      Alcotest.(check bool) (name ^ ", is_on") (s <> "off") (Plan.is_on plan e))
    Effect.all expected

let off = "off"

let what_calls () =
  check "an empty scene" [] [ off; off; off; off ];
  check "only a ball" [ matte ] [ off; off; off; off ];
  check "a light and nothing to shine on" [ point ] [ off; off; off; off ];
  check "a ball and a light" [ matte; point ]
    [ off; "point light made.scene:4:1"; "point light made.scene:4:1"; off ];
  check "a light without shadows" [ matte; unshadowed ]
    [ off; "point light made.scene:4:1"; off; off ];
  check "one light with shadows, one without"
    [ unshadowed; matte; point ]
    [
      off;
      "point light made.scene:3:1; point light made.scene:5:1";
      "point light made.scene:5:1";
      off;
    ];
  check "a black light" [ matte; unlit ] [ off; off; off; off ];
  check "a black ball" [ black; point; "(ambient 1)" ] [ off; off; off; off ];
  check "a mirror and a light"
    [ mirror; point; "(ambient 1)" ]
    [ off; off; off; "mirror surface made.scene:3:1" ];
  check "ambient light" [ "(ambient .1)"; matte ]
    [ "ambient light made.scene:3:1"; off; off; off ];
  check "black ambient light" [ "(ambient 0)"; matte ] [ off; off; off; off ];
  check "other lights"
    [
      matte;
      "(light (directional (direction 0 -1 0) (irradiance 1)))";
      "(light (spot (at 0 9 0) (toward 0 0 0) (intensity 1) (inner 3) (outer \
       5)))";
    ]
    (let both = "directional light made.scene:4:1; spot light made.scene:5:1" in
     [ off; both; both; off ]);
  check "glazed"
    [
      ball ~material:"(material tile)" ();
      "(material tile (glazed (color .5) (mirror .2)))";
      point;
      "(ambient .1)";
    ]
    [
      "ambient light made.scene:6:1";
      "point light made.scene:5:1";
      "point light made.scene:5:1";
      "material tile made.scene:4:1";
    ];
  check "what is defined and not used calls for nothing"
    [ "(define m " ^ mirror ^ ")"; "(material shiny (mirror))" ]
    [ off; off; off; off ]

let limits () =
  let depth forms = Plan.depth (Plan.of_scene (Lit.scene forms)) in
  Alcotest.(check int)
    "nothing reflects" 0
    (depth [ matte; point; "(render (depth 5))" ]);
  Alcotest.(check int)
    "the scene's limit" 5
    (depth [ mirror; "(render (depth 5))" ]);
  Alcotest.(check int) "the default" 8 (depth [ mirror ]);
  Alcotest.(check int)
    "forced, but nothing reflects" 0
    (Plan.depth (Plan.all (Lit.scene [ matte ])))

let forced s =
  let least = Plan.of_scene s and all = Plan.all s in
  List.for_all
    (fun e ->
      Plan.is_on all e
      &&
      match (Plan.status least e, Plan.status all e) with
      | Off, Forced -> true
      | (Called _ as a), b -> Plan.equal_status a b
      | (Off | Forced), _ -> false)
    Effect.all

let compiled s =
  let surface = Assembly.surface s in
  let names plan =
    List.map (fun (e, _) -> Effect.name e) (Plan.compile plan s surface)
  in
  let plan = Plan.of_scene s in
  let expected =
    List.filter
      (fun e -> Plan.is_on plan e && not (Effect.equal e Shadows))
      Effect.all
  in
  names plan = List.map Effect.name expected
  && names (Plan.all s) = [ "ambient"; "direct light"; "mirror" ]

(* Off means that nothing is traced: the counters stay at 0. *)
let idle s =
  let plan = Plan.of_scene s in
  let { Shot.tally; _ } = Lit.rendered s in
  List.for_all
    (fun e ->
      match Effect.rays e with
      | Some counter when not (Plan.is_on plan e) -> Tally.get tally counter = 0
      | Some _ | None -> true)
    Effect.all
  && Tally.get tally Camera_rays = s.width * s.height * s.settings.spp

let suite =
  ( "plans",
    [
      Law.example "what calls for each effect, and where" what_calls;
      Law.example "the depth is 0 if nothing reflects, else the scene's" limits;
      Law.law ~count:300 ~print:Drawn.show
        "all turns on the rest and keeps the reasons" (Drawn.scene Round) forced;
      Law.law ~count:300 ~print:Drawn.show
        "the terms of what is on are compiled, in order, and no others"
        (Drawn.scene Round) compiled;
      Law.law ~count:200 ~print:Drawn.show
        "an effect that is off traces no rays" (Drawn.scene Round) idle;
    ] )
