open Candor

let ppm levels =
  "P3\n2 1\n255\n" ^ String.concat " " (List.map string_of_int levels)

let write_pictures () =
  write "a.ppm" (ppm [ 10; 20; 30; 40; 50; 60 ]);
  write "b.ppm" (ppm [ 13; 20; 30; 40; 46; 60 ])

let number path j =
  match Json_reader.get [ path ] j with
  | Number s -> float_of_string s
  | _ -> Alcotest.fail path

(* d is 3 and 4 of six: rmse √(25/6), mae 7/6, max 4. *)
let measures () =
  write_pictures ();
  let j = Json_reader.parse (fine [ "diff"; "a.ppm"; "b.ppm"; "--json" ]).out in
  Alcotest.(check (float 1e-12)) "rmse" (sqrt (25. /. 6.)) (number "rmse" j);
  Alcotest.(check (float 1e-12)) "mae" (7. /. 6.) (number "mae" j);
  Alcotest.(check (float 0.)) "max" 4. (number "max" j);
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

let write_black_and_white () =
  write "black.ppm" (ppm [ 0; 0; 0; 0; 0; 0 ]);
  write "white.ppm" (ppm [ 255; 255; 255; 255; 255; 255 ])

(* Even pictures are the same at any distance. The authors' program makes this
   0.967388, in single precision. *)
let flip () =
  write_black_and_white ();
  let diff args = (fine ("diff" :: "black.ppm" :: "white.ppm" :: args)).out in
  mentions (diff []) "flip       0.96738 (67 pixels per degree)\n";
  mentions
    (diff [ "--ppd"; "40" ])
    "flip       0.96738 (40 pixels per degree)\n";
  let j = Json_reader.parse (diff [ "--json"; "--ppd=40" ]) in
  Alcotest.(check (float 3e-5)) "flip" 0.967388 (number "flip" j);
  Alcotest.(check (float 0.)) "ppd" 40. (number "ppd" j);
  mentions (fine [ "diff"; "black.ppm"; "black.ppm" ]).out "flip       0 (67";
  List.iter
    (fun n ->
      fails 2 "expected a number from 1 to 1000"
        [ "diff"; "black.ppm"; "white.ppm"; "--ppd"; n ])
    [ "0"; "1001"; "nan"; "far" ]

let decoded name =
  match Candor_image.Picture_file.decode (read name) with
  | Ok content -> content
  | Error why -> Alcotest.fail why

let colour name =
  match decoded name with
  | Linear _ -> Alcotest.fail name
  | Display r -> List.init 3 (Candor_image.Raster.sample r 1 0)

let heatmap () =
  write_black_and_white ();
  let diff name = [ "diff"; "black.ppm"; "white.ppm"; "--heatmap"; name ] in
  List.iter
    (fun name -> mentions (fine (diff name)).out "flip")
    [ "h.png"; "h.ppm"; "h.pfm" ];
  let expected = [ 252; 238; 176 ] in
  Alcotest.(check (list int)) "png" expected (colour "h.png");
  Alcotest.(check (list int)) "ppm" expected (colour "h.ppm");
  (match decoded "h.pfm" with
  | Display _ -> Alcotest.fail "pfm"
  | Linear p ->
      let { Candor_colour.Rgb.r; g; b } = Candor_image.Picture.pixel p 1 0 in
      List.iter (Alcotest.(check (float 3e-5)) "pfm" 0.967388) [ r; g; b ]);
  fails 2 "unknown extension" (diff "h.jpg");
  fails 2 "no extension" (diff "-");
  fails 1 "cannot write" (diff "none/h.png");
  write "one.ppm" "P3\n1 1\n255\n0 0 0";
  fails 1 "differ in size"
    [ "diff"; "black.ppm"; "one.ppm"; "--heatmap"; "new.png" ];
  check_entries "nothing else is left"
    [ "black.ppm"; "h.pfm"; "h.png"; "h.ppm"; "one.ppm"; "white.ppm" ];
  code_is "missed, and written" 3
    (run (diff "missed.png" @ [ "--threshold"; "1" ]));
  Alcotest.(check (list int)) "missed" expected (colour "missed.png")

let suite =
  ( "diff",
    [
      example "measures worked out by hand" measures;
      example "how different pictures look" flip;
      example "heat maps in every format, and what goes wrong" heatmap;
      example "above the threshold it ends with 3" threshold;
      with_scene "pictures of all formats, and what cannot be compared" formats;
    ] )
