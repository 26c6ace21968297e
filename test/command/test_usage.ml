open Candor

let version () = check_text "its number" "0.1.0\n" (fine [ "--version" ]).out

let helps () =
  List.iter
    (fun (command, words) ->
      let r = fine [ command; "--help" ] in
      List.iter (mentions r.out)
        (("candor " ^ command) :: "EXIT STATUS" :: words);
      check_text "standard error" "" r.err)
    [
      ( "render",
        [
          "SCENE";
          "-o FILE";
          "--output";
          "--size";
          "--spp";
          "--depth";
          "--cutoff";
          "--seed";
          "-j N";
          "--crop";
          "--filter";
          "--all-effects";
          "--error";
          "--confidence";
          "--time";
          "--map";
          "--save-map";
          "--naive-math";
          "--stats";
          "--quiet";
          "--binary";
          ".pfm";
        ] );
      ("check", [ "SCENE" ]);
      ("explain", [ "SCENE"; "--json"; "--depth" ]);
      ( "cost",
        [ "SCENE"; "--budget"; "--csv"; "--html"; "-j N"; "--spp"; "--quiet" ]
      );
      ("trace", [ "SCENE"; "X"; "Y"; "--sample"; "--naive-math" ]);
      ("cast", [ "SCENE"; "--hex"; "tmax"; "--naive-math" ]);
      ("diff", [ "A"; "B"; "--json"; "--threshold" ]);
    ];
  let r = fine [ "--help" ] in
  List.iter (mentions r.out)
    [ "render"; "check"; "explain"; "cost"; "trace"; "cast"; "diff"; "130" ]

let wrong_lines () =
  fails 2 "COMMAND" [];
  fails 2 "unknown command" [ "frob" ];
  List.iter
    (fun c ->
      fails 2 "SCENE" [ c ];
      fails 2 "unknown option" [ c; "s.scene"; "--frob" ])
    [ "render"; "check"; "explain"; "cost"; "cast"; "trace" ];
  fails 2 "unknown option" [ "render"; "s.scene"; "--hex" ];
  List.iter
    (fun c -> fails 2 "unknown option" [ c; "s.scene"; "--naive-math" ])
    [ "explain"; "check" ];
  fails 2 "X" [ "trace"; "s.scene" ];
  fails 2 "Y" [ "trace"; "s.scene"; "1" ];
  fails 2 "" [ "trace"; "s.scene"; "one"; "2" ];
  fails 2 "B" [ "diff"; "a.ppm" ];
  fails 2 "too many" [ "diff"; "a.ppm"; "b.ppm"; "c.ppm" ];
  fails 2 "too many" [ "render"; "s.scene"; "t.scene" ];
  check_entries "nothing is written" [ "s.scene" ]

let wrong_values () =
  let render option values =
    List.iter
      (fun v -> fails 2 option [ "render"; "s.scene"; option ^ "=" ^ v ])
      values
  in
  render "--size"
    [
      "";
      "0x5";
      "5x0";
      "-3x4";
      "640";
      "640x";
      "640x480x2";
      "axb";
      "99999999x1";
      "6.5x4";
      "640 x480";
    ];
  render "--spp" [ "0"; "-1"; "x"; "1.5"; "" ];
  render "--depth" [ "-1"; "x"; "2.5" ];
  render "--cutoff" [ "-1"; "nan"; "inf"; "x" ];
  render "--seed" [ "x"; "1.5" ];
  render "--filter" [ "x"; "boxes" ];
  render "--error" [ "0"; "-1"; "nan"; "inf"; "x"; "" ];
  render "--confidence" [ "0"; "1"; "2"; "-.5"; "nan"; "95%"; "" ];
  render "--time" [ "0"; "0s"; "-1s"; "nan"; "1e400s"; "s"; "x"; "1d"; "" ];
  render "--crop"
    [
      "";
      "1,2,3";
      "0,0,0,5";
      "5,0,2,5";
      "0,5,5,5";
      "-1,0,5,5";
      "0,0,5,5,5";
      "a,b,c,d";
      "0,0,25,18";
      "0,0,24,19";
      "0 0 5 5";
    ];
  List.iter
    (fun v -> fails 2 "-j" [ "render"; "s.scene"; "-j"; v ])
    [ "0"; "x"; "1000"; "1.5" ];
  List.iter
    (fun v -> fails 2 "--budget" [ "cost"; "s.scene"; "--budget"; v ])
    [ "0"; "0s"; "x"; ""; "s"; "20x"; "nan"; "inf"; "1 s"; "1.2.3" ];
  fails 2 "" [ "cost"; "s.scene"; "--budget=-1" ];
  fails 2 "" [ "render"; "s.scene"; "-j"; "-1" ];
  fails 2 ".ppm" [ "render"; "s.scene"; "-o"; "a.jpg" ];
  fails 2 "" [ "render"; "s.scene"; "-o"; "noextension" ];
  fails 2 "--size" [ "render"; "s.scene"; "--size" ];
  fails 2 "--sample" [ "trace"; "s.scene"; "1"; "2"; "--sample=x" ];
  fails 2 "--threshold" [ "diff"; "a.ppm"; "b.ppm"; "--threshold=x" ];
  check_entries "nothing is written" [ "s.scene" ]

let not_yet () =
  let refused args = fails 2 "not supported yet" args in
  List.iter
    (fun (option, value) ->
      refused [ "render"; "s.scene"; option; value ];
      refused [ "render"; option ^ "=" ^ value; "s.scene"; "-o"; "x.ppm" ])
    [ ("--part", "1/2") ];
  List.iter
    (fun option -> refused [ "render"; "s.scene"; option ])
    [ "--resume" ];
  refused [ "merge"; "a"; "b"; "-o"; "c.ppm" ];
  mentions (run [ "render"; "s.scene"; "--part"; "1/2" ]).err "--part";
  check_entries "nothing is written" [ "s.scene" ]

let unstyled () =
  let r = run ~env:[| "TERM=xterm-256color" |] [ "render"; "--frob" ] in
  Alcotest.(check bool)
    "no escape codes in usage" false
    (String.contains r.err '\027');
  let r = run ~env:[| "TERM=xterm-256color" |] [ "render"; "--help" ] in
  Alcotest.(check bool) "nor in help" false (String.contains r.out '\027')

(* Nobody listens on standard error. *)
let unheard () =
  let code script expected =
    Alcotest.(check int) script expected (shell script).code
  in
  code "\"$CANDOR\" check none.scene 2>&-" 1;
  code "\"$CANDOR\" render s.scene -o a.ppm 2>&-" 0;
  code "echo x | \"$CANDOR\" cast s.scene 2>/dev/full" 1;
  code "\"$CANDOR\" render s.scene -o b.ppm 2>/dev/full" 0;
  check_text "the picture is there" (read "a.ppm") (read "b.ppm")

let suite =
  ( "usage",
    [
      example "--version says which" version;
      example "every command has a help page that names its options" helps;
      with_scene "a wrong command line ends with 2" wrong_lines;
      with_scene "wrong values of options end with 2 and name the option"
        wrong_values;
      with_scene "what is still to come is refused, with 2" not_yet;
      example "text that is not for a terminal is not styled" unstyled;
      with_scene "a closed or full standard error changes no exit code" unheard;
    ] )
