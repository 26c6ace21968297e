open Candor

let bad =
  "(scene (camera (orthographic (eye 0 0 5) (look-at 0 0 0) (height 2)))\n\
  \ (sphere (radius -1) (center 0 0 0))\n\
  \ (spere))\n"

let right () =
  write "t.scene" scene;
  let r = fine [ "check"; "s.scene"; "t.scene" ] in
  check_text "standard output" "" r.out;
  check_text "standard error" "" r.err

let several () =
  write "bad.scene" bad;
  write "worse.scene" "(scene";
  let r =
    run [ "check"; "bad.scene"; "s.scene"; "none.scene"; "worse.scene" ]
  in
  code_is "exit code" 1 r;
  check_text "standard output" "" r.out;
  List.iter (mentions r.err)
    [ "bad.scene:2:"; "bad.scene:3:"; "none.scene"; "worse.scene:1:" ];
  check_entries "nothing is written" [ "bad.scene"; "s.scene"; "worse.scene" ]

let suite =
  ( "check",
    [
      with_scene "says nothing of right scenes" right;
      with_scene "tells all errors of all files" several;
    ] )
