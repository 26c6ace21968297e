open Candor

let golden =
  {|ambient        on   a constant stands in for light that bounces
      ambient light  [s.scene:6:3]
direct light   on   lights shine straight on surfaces
      point light  [s.scene:8:3]
      directional light  [s.scene:9:3]
shadows        on   surfaces between a light and a point take its light away
      point light  [s.scene:8:3]
      not for the light with (shadows no)  [s.scene:9:3]
mirror         on   surfaces reflect what is in front of them
      glazed surface  [s.scene:10:3]
      mirror surface  [s.scene:11:3]
anti-aliasing  on   pixels are the mean of samples, where one does not decide them
      4 samples a pixel
depth          8    steps from surface to surface along one path at most: the scene's limit
off, since nothing in the scene asks for it:
  emission          surfaces that give light are seen shining
  soft shadows      surfaces that give light shine on others
  sky light         the bright parts of a background picture shine on surfaces
  refraction        glass reflects a part of the light and bends the rest
  dispersion        glass bends blue light more than red
  absorption        coloured glass takes light away on its way
  subsurface        light wanders inside translucent bodies
  gloss             rough metal and plastic blur what they reflect
  indirect light    light that bounces off surfaces is followed
  fog               a medium takes light away and scatters it
  depth of field    what is not at the distance of focus is blurred
  motion blur       what moves while the shutter is open is smeared
  textures          colours vary over surfaces
  smooth normals    triangles shade as the curved surface they stand for
|}

let bare =
  "(scene (camera (orthographic (eye 0 0 5) (look-at 0 0 0) (height 2)))\n\
  \ (sphere (radius 1) (center 0 0 0)))\n"

(* The same effects, but those that are off stand below. *)
let bare_golden =
  {|anti-aliasing  on   pixels are the mean of samples, where one does not decide them
      16 samples a pixel
depth          0    steps from surface to surface along one path at most: nothing reflects
off, since nothing in the scene asks for it:
  emission          surfaces that give light are seen shining
  ambient           a constant stands in for light that bounces
  direct light      lights shine straight on surfaces
  shadows           surfaces between a light and a point take its light away
|}

let texts () =
  check_text "everything on" golden (fine [ "explain"; "s.scene" ]).out;
  write "t.scene" bare;
  mentions (fine [ "explain"; "t.scene" ]).out bare_golden;
  let r = fine [ "explain"; "t.scene"; "--all-effects" ] in
  mentions r.out
    "mirror         on   surfaces reflect what is in front of them; nothing \
     asks for it (--all-effects)";
  write "a.obj" "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\nf 1 1 3\n";
  write "m.scene"
    "(scene (camera (panorama (eye 0 0 5) (look-at 0 0 0)))\n (mesh a.obj))";
  mentions (fine [ "explain"; "m.scene" ]).out
    "left out       2    faces without area in a.obj  [m.scene:2:2]";
  mentions (fine [ "explain"; "s.scene"; "--depth"; "3" ]).out
    "depth          3 "

let many () =
  let ball i =
    Printf.sprintf
      "(sphere (center %d 0 0) (radius 1) (material (mirror (color .%d))))" i i
  in
  write "t.scene"
    ("(scene (camera (orthographic (eye 0 0 5) (look-at 0 0 0) (height 2)))\n"
    ^ String.concat "\n" (List.init 9 (fun i -> ball (i + 1)))
    ^ ")");
  mentions (fine [ "explain"; "t.scene" ]).out
    "mirror surface  [t.scene:7:1]\n      and 3 more\n"

let json () =
  let j = Json_reader.parse (fine [ "explain"; "s.scene"; "--json" ]).out in
  let get = Json_reader.get in
  Alcotest.(check bool) "depth" true (get [ "depth" ] j = Number "8");
  Alcotest.(check bool)
    "mirror is on" true
    (get [ "effects"; "mirror"; "on" ] j = Bool true);
  Alcotest.(check bool)
    "why" true
    (get [ "effects"; "mirror"; "why" ] j
    = List
        [
          Object
            [
              ("what", String "glazed surface");
              ("file", String "s.scene");
              ("line", Number "10");
              ("column", Number "3");
            ];
          Object
            [
              ("what", String "mirror surface");
              ("file", String "s.scene");
              ("line", Number "11");
              ("column", Number "3");
            ];
        ]);
  write "t.scene" bare;
  let j = Json_reader.parse (fine [ "explain"; "t.scene"; "--json" ]).out in
  List.iter
    (fun e ->
      Alcotest.(check bool)
        (e ^ " is off") true
        (get [ "effects"; e; "on" ] j = Bool false
        && get [ "effects"; e; "why" ] j = List []))
    (List.filter
       (( <> ) Candor_effect.Effect.Anti_aliasing)
       Candor_effect.Effect.all
    |> List.map Candor_effect.Effect.name)

let suite =
  ( "explain",
    [
      with_scene "golden texts: all on, all off, forced" texts;
      example "long lists of reasons are cut" many;
      with_scene "the same as JSON" json;
    ] )
