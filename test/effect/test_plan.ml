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

(* What a plan says of the effects that are on, in order; but that there are
   several samples a pixel by default. *)
let check name forms expected =
  let plan = Plan.of_scene (Lit.scene forms) in
  let said =
    List.filter (fun e -> Plan.is_on plan e && e <> Anti_aliasing) Effect.all
    |> List.map (fun e -> (Effect.name e, status plan e))
  in
  Alcotest.(check (list (pair string string))) name expected said

let lit_by what = [ ("direct light", what); ("shadows", what) ]

let what_calls () =
  check "an empty scene" [] [];
  check "only a ball" [ matte ] [];
  check "a light and nothing to shine on" [ point ] [];
  check "a ball and a light" [ matte; point ]
    (lit_by "point light made.scene:4:1");
  check "a light without shadows" [ matte; unshadowed ]
    [ ("direct light", "point light made.scene:4:1") ];
  check "one light with shadows, one without"
    [ unshadowed; matte; point ]
    [
      ("direct light", "point light made.scene:3:1; point light made.scene:5:1");
      ("shadows", "point light made.scene:5:1");
    ];
  check "a black light" [ matte; unlit ] [];
  check "a black ball" [ black; point; "(ambient 1)" ] [];
  check "a mirror and a light"
    [ mirror; point; "(ambient 1)" ]
    [ ("mirror", "mirror surface made.scene:3:1") ];
  check "ambient light" [ "(ambient .1)"; matte ]
    [ ("ambient", "ambient light made.scene:3:1") ];
  check "black ambient light" [ "(ambient 0)"; matte ] [];
  check "other lights"
    [
      matte;
      "(light (directional (direction 0 -1 0) (irradiance 1)))";
      "(light (spot (at 0 9 0) (toward 0 0 0) (intensity 1) (inner 3) (outer \
       5)))";
    ]
    (lit_by "directional light made.scene:4:1; spot light made.scene:5:1");
  check "glazed"
    [
      ball ~material:"(material tile)" ();
      "(material tile (glazed (color .5) (mirror .2)))";
      point;
      "(ambient .1)";
    ]
    ([ ("ambient", "ambient light made.scene:6:1") ]
    @ lit_by "point light made.scene:5:1"
    @ [ ("mirror", "material tile made.scene:4:1") ]);
  check "what is defined and not used calls for nothing"
    [ "(define m " ^ mirror ^ ")"; "(material shiny (mirror))" ]
    []

let of_material m = ball ~material:("(material " ^ m ^ ")") ()

let what_else_calls () =
  check "a lamp alone"
    [ of_material "(emitter (radiance 1))" ]
    [ ("emission", "emitting surface made.scene:3:1") ];
  check "a lamp that shines on a ball"
    [ matte; of_material "(emitter (radiance 1))" ]
    [
      ("emission", "emitting surface made.scene:4:1");
      ("soft shadows", "emitting surface made.scene:4:1");
    ];
  check "a glowing ball that lights itself"
    [ of_material "(matte (color .5) (emission 1))"; "(indirect-light)" ]
    [
      ("emission", "matte surface made.scene:3:1");
      ("soft shadows", "matte surface made.scene:3:1");
      ("indirect light", "indirect light made.scene:4:1");
    ];
  check "indirect light on nothing"
    [ mirror; "(indirect-light)" ]
    [ ("mirror", "mirror surface made.scene:3:1") ];
  check "clear glass"
    [ of_material "(glass (index 1.5))" ]
    [ ("refraction", "glass surface made.scene:3:1") ];
  check "coloured glass that disperses"
    [ of_material "(glass (index 1.5) (absorption .1) (dispersion 30))" ]
    (List.map
       (fun e -> (e, "glass surface made.scene:3:1"))
       [ "refraction"; "dispersion"; "absorption" ]);
  check "translucent"
    [ of_material "(translucent (index 1.3) (scattering 1) (absorption .1))" ]
    (List.map
       (fun e -> (e, "translucent surface made.scene:3:1"))
       [ "refraction"; "subsurface" ]);
  check "rough metal"
    [ of_material "(metal (reflectance .9) (roughness .2))" ]
    [ ("gloss", "metal surface made.scene:3:1") ];
  check "smooth metal"
    [ of_material "(metal (reflectance .9) (roughness 0))" ]
    [ ("mirror", "metal surface made.scene:3:1") ];
  check "smooth plastic"
    [ of_material "(plastic (color .9) (index 1.5) (roughness 0))" ]
    [
      ("mirror", "plastic surface made.scene:3:1");
      ("gloss", "plastic surface made.scene:3:1");
    ];
  check "fog"
    [ "(fog (extinction .1) (albedo .5))"; point ]
    ([]
    @ lit_by "point light made.scene:4:1"
    @ [ ("fog", "fog made.scene:3:1") ]);
  check "smoke, which only absorbs"
    [ "(fog (extinction .1) (albedo 0))"; point ]
    [ ("fog", "fog made.scene:3:1") ];
  check "clear fog" [ "(fog (extinction 0) (albedo .5))" ] [];
  check "a texture"
    [ of_material "(matte (color (checker 0 1)))" ]
    [ ("textures", "matte surface made.scene:3:1") ];
  check "a checker that is all alike is a texture still"
    [ of_material "(mirror (color (checker 1 1)))" ]
    [
      ("mirror", "mirror surface made.scene:3:1");
      ("textures", "mirror surface made.scene:3:1");
    ];
  check "a triangle with normals"
    [ "(triangle (0 0 0) (1 0 0) (0 1 0) (normals (0 0 1) (0 1 1) (1 0 1)))" ]
    [ ("smooth normals", "triangle with normals made.scene:3:1") ];
  check "motion that the camera does not see"
    [ "(sphere (center 0 0 0) (radius 1) (motion 1 0 0))" ]
    []

let limits () =
  let depth forms : int option =
    match Plan.depth (Plan.of_scene (Lit.scene forms)) with
    | Steps { most; _ } -> Some most
    | Unbounded _ -> None
  in
  let check name expected forms =
    Alcotest.(check (option int)) name expected (depth forms)
  in
  check "nothing reflects" (Some 0) [ matte; point; "(render (depth 5))" ];
  check "the scene's limit" (Some 5) [ mirror; mirror; "(render (depth 5))" ];
  check "the default" (Some 8) [ mirror; mirror ];
  check "one flat mirror reflects once" (Some 1)
    [ matte; "(triangle (0 0 0) (1 0 0) (0 1 0) (material (mirror)))" ];
  check "not at all at depth 0" (Some 0)
    [
      "(triangle (0 0 0) (1 0 0) (0 1 0) (material (mirror)))";
      "(render (depth 0))";
    ];
  check "two of them face each other" (Some 8)
    [
      "(triangle (0 0 0) (1 0 0) (0 1 0) (material (mirror)))";
      "(triangle (0 0 1) (1 0 1) (0 1 1) (material (mirror)))";
    ];
  check "from within a ball there may be more" (Some 8) [ mirror ];
  check "indirect light" None [ matte; "(indirect-light)" ];
  check "indirect light of some depth" (Some 3)
    [ matte; "(indirect-light)"; "(render (depth 3))" ];
  Alcotest.(check bool)
    "forced, but nothing reflects" true
    (Plan.equal_bound
       (Plan.depth (Plan.all (Lit.scene [ matte ])))
       (Steps { most = 0; why = "nothing reflects" }))

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

(* Effects that are parts of others, of the camera or of what is between have no
   term. *)
let has_term : Effect.t -> bool = function
  | Emission | Ambient | Direct | Soft_shadows | Sky_light | Mirror | Refraction
  | Gloss | Indirect ->
      true
  | Shadows | Dispersion | Absorption | Subsurface | Fog | Depth_of_field
  | Motion_blur | Textures | Smooth_normals | Anti_aliasing ->
      false

let compiled s =
  let surface = Candor_optics.Skin.surface s in
  let terms plan = List.map fst (Plan.compile plan s surface).terms in
  let plan = Plan.of_scene s in
  let may_be e = Plan.is_on plan e && has_term e in
  List.for_all may_be (terms plan)
  && List.for_all has_term (terms (Plan.all s))
  && List.equal Effect.equal (terms plan)
       (List.filter (fun e -> List.mem e (terms plan)) Effect.all)

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
  && Tally.get tally Camera_rays + Tally.get tally Spared_samples
     = s.width * s.height * s.settings.spp

let suite =
  ( "plans",
    [
      Law.example "what calls for each effect, and where" what_calls;
      Law.example "what calls for the others" what_else_calls;
      Law.example
        "the depth is bounded where that is proved, else as the scene says"
        limits;
      Law.law ~count:300 ~print:Drawn.show
        "all turns on the rest and keeps the reasons" (Drawn.scene Round) forced;
      Law.law ~count:300 ~print:Drawn.show
        "only terms of what is on are compiled, in order" (Drawn.scene Round)
        compiled;
      Law.law ~count:200 ~print:Drawn.show
        "an effect that is off traces no rays" (Drawn.scene Round) idle;
    ] )
