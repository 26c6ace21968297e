open Candor
open Candor_image

let decode name =
  match Picture_file.decode (read name) with
  | Ok content -> content
  | Error why -> Alcotest.failf "%s: %s" name why

let raster name =
  match decode name with
  | Display r -> r
  | Linear _ -> Alcotest.failf "%s is linear" name

let linear name =
  match decode name with
  | Linear p -> p
  | Display _ -> Alcotest.failf "%s is not linear" name

let render args = ignore (fine ("render" :: "s.scene" :: args) : ended)

let default_name () =
  Sys.mkdir "scenes" 0o777;
  write "scenes/first.try.scene" scene;
  Sys.mkdir "work" 0o777;
  Sys.chdir "work";
  let r = fine [ "render"; "../scenes/first.try.scene" ] in
  check_entries "in the current folder" [ "first.try.ppm" ];
  mentions r.err "first.try.ppm";
  Sys.chdir ".."

let formats () =
  List.iter render
    [
      [ "-o"; "a.ppm" ];
      [ "--binary"; "-o"; "b.PPM" ];
      [ "-o"; "c.png" ];
      [ "-o"; "d.pfm" ];
    ];
  let a = raster "a.ppm" in
  Alcotest.(check bool) "P3 and P6" true (Raster.equal a (raster "b.PPM"));
  Alcotest.(check bool) "P3 and PNG" true (Raster.equal a (raster "c.png"));
  let d = linear "d.pfm" in
  (* Radiance was rounded to 32 bits on its way: where that moves a value across
     a border between levels, the level may differ by 1. *)
  for y = 0 to 17 do
    for x = 0 to 23 do
      let c = Picture.pixel d x y in
      List.iteri
        (fun i v ->
          let n = Candor_colour.Display.level v in
          if
            abs (n - Raster.sample a x y i) > 0
            && Float.abs (Float.rem (Candor_colour.Display.encode v) 1. -. 0.5)
               > 1e-4
          then
            Alcotest.failf "pixel %d %d: %d and %d" x y n
              (Raster.sample a x y i))
        [ c.r; c.g; c.b ]
    done
  done;
  Alcotest.(check bool)
    "P3" true
    (String.starts_with ~prefix:"P3\n24 18\n255\n" (read "a.ppm"));
  Alcotest.(check bool)
    "P6" true
    (String.starts_with ~prefix:"P6\n24 18\n255\n" (read "b.PPM"));
  Alcotest.(check bool)
    "PFM" true
    (String.starts_with ~prefix:"PF\n24 18\n-1" (read "d.pfm"));
  Alcotest.(check bool)
    "PNG" true
    (String.starts_with ~prefix:"\137PNG\r\n" (read "c.png"))

let to_stdout () =
  render [ "-o"; "a.ppm" ];
  let r = fine [ "render"; "s.scene"; "-o"; "-" ] in
  check_text "the same bytes" (read "a.ppm") r.out;
  let r = fine [ "render"; "s.scene"; "-o"; "-"; "--binary"; "--quiet" ] in
  render [ "-o"; "b.ppm"; "--binary" ];
  check_text "binary" (read "b.ppm") r.out;
  check_entries "no other file" [ "a.ppm"; "b.ppm"; "s.scene" ]

let same_bytes () =
  List.iter
    (fun extension ->
      let name tag = tag ^ extension in
      render [ "-o"; name "a"; "-j"; "1" ];
      List.iter
        (fun (tag, args) ->
          render ([ "-o"; name tag ] @ args);
          check_text (name tag) (read (name "a")) (read (name tag)))
        [
          ("two", [ "-j"; "2" ]);
          ("five", [ "-j"; "5" ]);
          ("again", [ "-j"; "1" ]);
          ("all", []);
          ("effects", [ "--all-effects" ]);
          ("crop", [ "--crop=0,0,24,18" ]);
          ("set", [ "--spp=4"; "--seed=0"; "--depth=8"; "--filter=box" ]);
        ])
    [ ".ppm"; ".pfm"; ".png" ]

let crop () =
  render [ "-o"; "all.pfm" ];
  render [ "-o"; "all.ppm" ];
  List.iter
    (fun ((x0, y0, x1, y1) as window) ->
      let crop = Printf.sprintf "--crop=%d,%d,%d,%d" x0 y0 x1 y1 in
      ignore window;
      render [ "-o"; "part.pfm"; crop; "-j"; "2" ];
      render [ "-o"; "part.ppm"; crop ];
      let all = linear "all.pfm" and part = linear "part.pfm" in
      let cut =
        Picture.init ~width:(x1 - x0) ~height:(y1 - y0) (fun x y ->
            Picture.pixel all (x0 + x) (y0 + y))
      in
      Alcotest.(check bool) (crop ^ ", linear") true (Picture.equal cut part);
      let all = raster "all.ppm" and part = raster "part.ppm" in
      for y = y0 to y1 - 1 do
        for x = x0 to x1 - 1 do
          for c = 0 to 2 do
            if Raster.sample all x y c <> Raster.sample part (x - x0) (y - y0) c
            then Alcotest.failf "%s: pixel %d %d" crop x y
          done
        done
      done)
    [ (0, 0, 1, 1); (23, 17, 24, 18); (3, 2, 20, 9); (0, 5, 24, 6) ]

let overrides () =
  let differs name args =
    render ([ "-o"; "b.pfm" ] @ args);
    Alcotest.(check bool)
      name false
      (String.equal (read "a.pfm") (read "b.pfm"))
  in
  render [ "-o"; "a.pfm" ];
  List.iter
    (fun a -> differs a [ a ])
    [
      "--spp=5";
      "--seed=1";
      "--depth=0";
      "--filter=tent";
      "--size=23x18";
      "--cutoff=0.3";
    ];
  render [ "-o"; "b.pfm"; "--size"; "30x20" ];
  let b = linear "b.pfm" in
  Alcotest.(check (pair int int))
    "its size" (30, 20)
    (Picture.width b, Picture.height b)

let quiet () =
  let r = fine [ "render"; "s.scene"; "--quiet" ] in
  check_text "standard error" "" r.err;
  check_text "standard output" "" r.out;
  let r = fine [ "render"; "s.scene" ] in
  check_text "standard output, not quiet" "" r.out;
  List.iter (mentions r.err)
    [
      "s.ppm  24x18  4 spp";
      "rays";
      "\n  sampling ";
      "\n  cut-off ";
      " tests needed more than plain doubles; 0 non-finite";
      "\n  output ";
    ];
  Alcotest.(check int)
    "five lines" 5
    (List.length (String.split_on_char '\n' (String.trim r.err)));
  let r = run [ "render"; "none.scene"; "--quiet" ] in
  Alcotest.(check bool) "errors are still told" true (r.err <> "")

let far =
  {|(scene
  (image (size 8 8))
  (camera (orthographic (eye 0 0 1e9) (look-at 0 0 0) (height 2)))
  (light (directional (direction 1 0 -1) (irradiance 1)))
  (sphere (center 0 0 0) (radius 1)))
|}

(* The textbook never takes care, and from afar it shows. *)
let naive () =
  let ledger args = (fine ([ "render"; "s.scene" ] @ args)).err in
  render [ "-o"; "a.pfm" ];
  let text = ledger [ "-o"; "b.pfm"; "--naive-math" ] in
  let numerics =
    List.find
      (String.starts_with ~prefix:"  numerics")
      (String.split_on_char '\n' text)
  in
  mentions numerics "  numerics   0 of ";
  mentions numerics " tests needed more than plain doubles; 0 non-finite";
  Alcotest.(check bool)
    "Candor needs more at times" false
    (contains (ledger [ "-o"; "c.pfm" ]) "  numerics   0 of ");
  check_text "without it the picture is Candor's" (read "a.pfm") (read "c.pfm");
  write "s.scene" far;
  render [ "-o"; "a.pfm" ];
  render [ "-o"; "b.pfm"; "--naive-math" ];
  Alcotest.(check bool)
    "another picture from afar" false
    (String.equal (read "a.pfm") (read "b.pfm"))

let stats () =
  render [ "-o"; "a.ppm"; "--stats"; "t.json"; "-j"; "2" ];
  let j = Json_reader.parse (read "t.json") in
  let int path =
    match Json_reader.get path j with
    | Number s -> (
        match int_of_string_opt s with
        | Some n -> n
        | None -> Alcotest.failf "%s is %s" (String.concat "." path) s)
    | _ -> Alcotest.failf "%s is no number" (String.concat "." path)
  in
  Alcotest.(check int) "camera rays" (24 * 18 * 4) (int [ "rays"; "camera" ]);
  let shadow = int [ "rays"; "shadow" ] and mirror = int [ "rays"; "mirror" ] in
  Alcotest.(check bool) "shadow and mirror rays" true (shadow > 0 && mirror > 0);
  Alcotest.(check int)
    "the total"
    ((24 * 18 * 4) + shadow + mirror)
    (int [ "rays"; "total" ]);
  Alcotest.(check int) "domains" 2 (int [ "domains" ]);
  Alcotest.(check (list int))
    "the picture" [ 24; 18; 4; 0 ]
    (List.map
       (fun f -> int [ "image"; f ])
       [ "width"; "height"; "spp"; "seed" ]);
  Alcotest.(check int)
    "non-finite samples" 0
    (int [ "ledger"; "numerics"; "non_finite" ]);
  List.iter
    (fun e ->
      Alcotest.(check bool)
        e true
        (Json_reader.get [ "effects"; e ] j = Bool true))
    [ "ambient"; "direct light"; "shadows"; "mirror" ];
  (match Json_reader.get [ "seconds" ] j with
  | Number s -> Alcotest.(check bool) "seconds" true (float_of_string s > 0.)
  | _ -> Alcotest.fail "no seconds");
  let r =
    fine [ "render"; "s.scene"; "-o"; "a.ppm"; "--quiet"; "--stats"; "-" ]
  in
  Alcotest.(check bool)
    "on standard output" true
    (Json_reader.get [ "rays"; "camera" ] (Json_reader.parse r.out)
    = Number "1728")

let suite =
  ( "render",
    [
      example "the default target is the scene's name in the current folder"
        default_name;
      with_scene "P3, P6, PNG and PFM agree" formats;
      with_scene "-o - is the PPM on standard output" to_stdout;
      with_scene "the same bytes for -j 1, 2, 5, runs and all effects"
        same_bytes;
      with_scene "--crop writes the full picture's pixels" crop;
      with_scene "the command line beats the scene" overrides;
      with_scene "--quiet says nothing; else a ledger on standard error" quiet;
      with_scene "--stats counts in whole numbers" stats;
      with_scene "--naive-math renders by the textbook, never carefully" naive;
    ] )
