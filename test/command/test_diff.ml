open Candor

let ppm levels =
  "P3\n2 1\n255\n" ^ String.concat " " (List.map string_of_int levels)

let write_pictures () =
  write "a.ppm" (ppm [ 10; 20; 30; 40; 50; 60 ]);
  write "b.ppm" (ppm [ 13; 20; 30; 40; 46; 60 ])

(* d is 3 and 4 of six: rmse √(25/6), mae 7/6, max 4. *)
let measures () =
  write_pictures ();
  let j = Json_reader.parse (fine [ "diff"; "a.ppm"; "b.ppm"; "--json" ]).out in
  let number path =
    match Json_reader.get [ path ] j with
    | Number s -> float_of_string s
    | _ -> Alcotest.fail path
  in
  Alcotest.(check (float 1e-12)) "rmse" (sqrt (25. /. 6.)) (number "rmse");
  Alcotest.(check (float 1e-12)) "mae" (7. /. 6.) (number "mae");
  Alcotest.(check (float 0.)) "max" 4. (number "max");
  Alcotest.(check bool)
    "unit" true
    (Json_reader.get [ "unit" ] j = String "1/255");
  let text = (fine [ "diff"; "a.ppm"; "b.ppm" ]).out in
  List.iter (mentions text) [ "rmse"; "mae"; "max"; "rel mse"; "2.04" ];
  mentions (fine [ "diff"; "a.ppm"; "a.ppm" ]).out "rmse       0"

let threshold () =
  write_pictures ();
  ignore (fine [ "diff"; "a.ppm"; "b.ppm"; "--threshold"; "2.05" ] : ended);
  ignore (fine [ "diff"; "a.ppm"; "a.ppm"; "--threshold"; "0" ] : ended);
  let r = run [ "diff"; "a.ppm"; "b.ppm"; "--threshold"; "2.04"; "--json" ] in
  code_is "above" 3 r;
  mentions r.err "above the threshold 2.04";
  ignore (Json_reader.parse r.out : Json_reader.t);
  code_is "text too" 3 (run [ "diff"; "a.ppm"; "b.ppm"; "--threshold=0" ])

let formats () =
  List.iter
    (fun args ->
      ignore (fine ("render" :: "s.scene" :: "--quiet" :: args) : ended))
    [
      [ "-o"; "a.ppm" ];
      [ "-o"; "b.png" ];
      [ "-o"; "c.pfm" ];
      [ "-o"; "d.pfm"; "--seed"; "3" ];
      [ "-o"; "e.ppm"; "--size"; "5x5" ];
    ];
  mentions (fine [ "diff"; "a.ppm"; "b.png"; "--threshold"; "0" ]).out "1/255";
  ignore (fine [ "diff"; "c.pfm"; "c.pfm"; "--threshold"; "0" ] : ended);
  code_is "another seed" 3
    (run [ "diff"; "c.pfm"; "d.pfm"; "--threshold"; "0" ]);
  fails 1 "" [ "diff"; "a.ppm"; "c.pfm" ];
  fails 1 "" [ "diff"; "a.ppm"; "e.ppm" ];
  fails 1 "none.ppm" [ "diff"; "a.ppm"; "none.ppm" ];
  fails 1 "s.scene" [ "diff"; "s.scene"; "a.ppm" ];
  fails 1 "directory" [ "diff"; "a.ppm"; "." ]

let suite =
  ( "diff",
    [
      example "measures worked out by hand" measures;
      example "above the threshold it ends with 3" threshold;
      with_scene "pictures of all formats, and what cannot be compared" formats;
    ] )
