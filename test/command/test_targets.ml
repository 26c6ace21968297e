open Candor

(* Noise in a soft shadow, and none around it. *)
let soft ?(size = "24 18") ?(render = "(render (spp 4))") () =
  Printf.sprintf
    {|(scene
  (image (size %s))
  (camera (orthographic (eye 0 0 5) (look-at 0 0 0) (height 2)))
  (background .2)
  %s
  (box (min -2 -1 -1) (max 2 .5 0) (material (matte (color .8))))
  (box (min -.3 -.9 .5) (max .3 .2 .6) (material (matte (color .8))))
  (sphere (center -2 2 3) (radius .7) (material (emitter (radiance 9)))))
|}
    size render

let with_soft name f =
  example name (fun () ->
      write "s.scene" (soft ());
      f ())

let render args = run ("render" :: "s.scene" :: args)

(* The ledger of a render that ends with [code]. *)
let ledger code args =
  let r = render args in
  code_is (String.concat " " args) code r;
  r.err

let line prefix text =
  match
    List.find_opt
      (String.starts_with ~prefix:("  " ^ prefix))
      (String.split_on_char '\n' text)
  with
  | Some line -> line
  | None -> Alcotest.failf "no line of %s in:\n%s" prefix text

let says args code part = mentions (line "sampling" (ledger code args)) part

let samples name =
  let j = Json_reader.parse (read name) in
  match Json_reader.get [ "image"; "samples" ] j with
  | Number s -> float_of_string s
  | _ -> Alcotest.fail "no number of samples"

(* {1 Errors} *)

let met () =
  write "s.scene" (soft ~size:"64 48" ());
  says [ "-o"; "a.ppm"; "--error=6"; "--stats=a.json" ] 0 "target 6 met";
  says [ "-o"; "b.ppm"; "--error=2"; "--stats=b.json" ] 0 "target 2 met";
  says [ "-o"; "c.ppm"; "--error=2"; "--confidence=.5" ] 0 "(50 %: ";
  if samples "b.json" <= samples "a.json" then
    Alcotest.fail "a smaller error takes more samples";
  let j = Json_reader.parse (read "b.json") in
  Alcotest.(check bool)
    "for programs too" true
    (Json_reader.get [ "ledger"; "sampling"; "met" ] j = Bool true)

let missed () =
  let r = render [ "-o"; "a.ppm"; "--error=0.01"; "--spp=4" ] in
  code_is "missed" 3 r;
  mentions r.err "target 0.01 missed: out of samples";
  mentions r.err "candor: the error of 0.01/255 was not reached";
  ignore (fine [ "render"; "s.scene"; "-o"; "b.ppm"; "--spp=4" ] : ended);
  check_text "the picture is written nevertheless" (read "b.ppm") (read "a.ppm");
  let r = render [ "-o"; "a.ppm"; "--error=0.01"; "--spp=4"; "--quiet" ] in
  code_is "missed, quietly" 3 r;
  check_text "an error is told"
    "candor: the error of 0.01/255 was not reached\n" r.err

let any_domains () =
  let picture j =
    let r = render [ "-o"; "a.pfm"; "--error=3"; "-j"; j ] in
    code_is j 0 r;
    read "a.pfm"
  in
  let one = picture "1" in
  List.iter (fun j -> check_text ("-j " ^ j) one (picture j)) [ "2"; "5"; "1" ]

(* {1 Times} *)

let seconds f =
  let start = Unix.gettimeofday () in
  f ();
  Unix.gettimeofday () -. start

(* A busy machine may take longer, but not a second less. *)
let time () =
  let spent =
    seconds (fun () ->
        let text = ledger 0 [ "-o"; "a.ppm"; "--time=1s" ] in
        mentions (line "sampling" text) "rms (95 %")
  in
  if not (0.85 <= spent && spent <= 3.) then
    Alcotest.failf "%.2f s instead of 1" spent;
  says
    [ "-o"; "a.ppm"; "--time=.3s"; "--error=.001" ]
    3 "target 0.001 missed: out of time";
  let spent =
    seconds (fun () ->
        says [ "-o"; "a.ppm"; "--time=1h"; "--error=6" ] 0 "target 6 met")
  in
  if spent > 60. then Alcotest.failf "%.0f s of an hour" spent

(* {1 Maps} *)

let repeated () =
  List.iter
    (fun extension ->
      let a = "a" ^ extension and b = "b" ^ extension in
      ignore (ledger 0 [ "-o"; a; "--error=3"; "--save-map=m" ] : string);
      ignore (ledger 0 [ "-o"; b; "--map=m"; "-j"; "1" ] : string);
      check_text extension (read a) (read b))
    [ ".ppm"; ".pfm"; ".png" ];
  ignore (ledger 0 [ "-o"; "b.ppm"; "--map=m"; "--save-map=n" ] : string);
  check_text "the same map" (read "m") (read "n");
  ignore (ledger 0 [ "-o"; "a.pfm"; "--crop=2,3,20,9"; "--map=m" ] : string);
  check_entries "nothing else"
    [
      "a.pfm"; "a.png"; "a.ppm"; "b.pfm"; "b.png"; "b.ppm"; "m"; "n"; "s.scene";
    ]

(* Also of renders that took as many everywhere, and of crops. *)
let uniform () =
  ignore
    (ledger 0 [ "-o"; "a.pfm"; "--crop=2,3,20,9"; "--save-map=m" ] : string);
  Alcotest.(check (list string))
    "four everywhere"
    ([ "candor-map 1 width 24 height 18 spp 4"; "window 2 3 20 9" ]
    @ List.init 6 (fun _ -> "4x18")
    @ [ "" ])
    (String.split_on_char '\n' (read "m"));
  ignore (ledger 0 [ "-o"; "b.pfm"; "--crop=2,3,20,9"; "--map=m" ] : string);
  check_text "the crop again" (read "a.pfm") (read "b.pfm");
  let outside = [ "render"; "s.scene"; "-o"; "c.pfm"; "--map=m" ] in
  fails 1 "m does not hold all of the crop" (outside @ [ "--crop=1,3,20,9" ])

let one_line r =
  Alcotest.(check int)
    "one message" 1
    (List.length (String.split_on_char '\n' (String.trim r.err)))

let refused code parts args =
  let args = "render" :: "s.scene" :: "-o" :: "a.ppm" :: args in
  List.iter (fun part -> fails code part args) parts;
  one_line (run args);
  Alcotest.(check bool) "no picture" false (Sys.file_exists "a.ppm")

let wrong_maps () =
  write "m" "candor-map 1 width 25 height 18 spp 64\nwindow 0 0 1 1\n4\n";
  refused 1 [ "m"; "25x18"; "24x18" ] [ "--map=m" ];
  refused 1 [ "none"; "such file" ] [ "--map=none" ];
  Sys.mkdir "d" 0o777;
  refused 1 [ "d: " ] [ "--map=d" ];
  write "m" "";
  refused 1 [ "m: line 1: " ] [ "--map=m" ];
  write "m"
    "candor-map 1 width 24 height 18 spp 64\nwindow 0 0 24 2\n4x24\n4x23\n";
  refused 1 [ "m: line 4: " ] [ "--map=m" ];
  write "m" "candor-map 1 width 24 height 18 spp 64\nwindow 0 0 24 1\n0x24\n";
  refused 1 [ "m: line 3: " ] [ "--map=m" ];
  refused 1 [ "no/m: cannot write" ] [ "--save-map=no/m" ]

let told_twice () =
  ignore (ledger 0 [ "-o"; "b.ppm"; "--save-map=m" ] : string);
  List.iter
    (fun option -> fails 2 "--map" [ "render"; "s.scene"; "--map=m"; option ])
    [ "--spp=4"; "--error=1"; "--time=1s" ];
  check_entries "nothing is written" [ "b.ppm"; "m"; "s.scene" ]

(* {1 What scenes say} *)

let of_scenes () =
  write "s.scene" (soft ~render:"(render (error 6))" ());
  says [ "-o"; "a.ppm" ] 0 "target 6 met";
  says [ "-o"; "a.ppm"; "--error=9" ] 0 "target 9 met";
  let text = ledger 0 [ "-o"; "a.ppm"; "--spp=8" ] in
  mentions text "8 spp";
  Alcotest.(check bool)
    "no target beside --spp" false
    (contains (line "sampling" text) "target");
  write "s.scene" (soft ~render:"(render (error .01) (spp 5))" ());
  says [ "-o"; "a.ppm" ] 3 "target 0.01 missed: out of samples";
  write "s.scene" (soft ~render:"(render (time .3s) (error .001))" ());
  says [ "-o"; "a.ppm" ] 3 "target 0.001 missed: out of time";
  Alcotest.(check bool)
    "--error alone leaves no time" false
    (contains (ledger 0 [ "-o"; "a.ppm"; "--error=9" ]) "missed");
  mentions (fine [ "explain"; "s.scene" ]).out
    "as many samples as the error takes"

(* A map does what it says, whatever the scene asks for. *)
let map_of_scene () =
  write "s.scene" (soft ~render:"(render (error 6))" ());
  ignore (ledger 0 [ "-o"; "a.pfm"; "--save-map=m" ] : string);
  ignore (ledger 0 [ "-o"; "b.pfm"; "--map=m" ] : string);
  check_text "the same bytes" (read "a.pfm") (read "b.pfm")

(* Where one sample is depends on how many the scene asked for. *)
let map_of_one () =
  write "s.scene" (soft ~render:"(render (spp 1))" ());
  List.iter
    (fun args ->
      ignore (ledger 0 ([ "-o"; "a.pfm"; "--save-map=m" ] @ args) : string);
      ignore (ledger 0 [ "-o"; "b.pfm"; "--map=m" ] : string);
      check_text (String.concat " " args) (read "a.pfm") (read "b.pfm"))
    [ []; [ "--time=.001s" ]; [ "--error=6" ]; [ "--spp=4" ] ]

let suite =
  ( "targets",
    [
      with_soft "--error is met, and the ledger says so" met;
      with_soft "an error that is not reached ends with 3, and a picture" missed;
      with_soft "--error gives the same bytes for -j 1, 2 and 5" any_domains;
      with_soft "--time is spent, no more; with --error, whichever is first"
        time;
      with_soft "--save-map and then --map give the same bytes" repeated;
      with_soft "so they do of a scene of one sample a pixel" map_of_one;
      with_soft "maps of crops and of uniform renders repeat them" uniform;
      with_soft "wrong maps end with 1 and one message, before any ray"
        wrong_maps;
      with_soft "--map beside --spp, --error or --time ends with 2" told_twice;
      example "scenes may ask for an error or a time; options replace both"
        of_scenes;
      example "a map repeats what a scene asked for" map_of_scene;
    ] )
