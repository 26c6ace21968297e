open Candor

(* Exact numbers all the way: a mirror at z = 0, a ball above the camera's line. *)
let mirrors =
  {|(scene
  (image (size 4 4))
  (camera (orthographic (eye 0 0 4) (look-at 0 0 0) (height 4)))
  (background (rgb .5 .25 1))
  (render (spp 1))
  (light (directional (direction 0 0 -2) (irradiance 1)))
  (box (min -4 -4 -1) (max 4 4 0) (material (glazed (color 0) (mirror .5))))
  (box (min 1 -4 5) (max 4 4 6) (material (matte (color 0)))))
|}

(* Proven error bounds are the surfaces' business. *)
let masked text =
  String.split_on_char '\n' text
  |> List.map (fun line ->
      if contains line "the true surface is within" then "  (bound)" else line)
  |> String.concat "\n"

let escapes =
  {|pixel 0 1, sample 0 of 1
camera ray, throughput (1 1 1)
  from (-1.5 0.5 4) along (0 0 -1)
  meets surface 0 [m.scene:7:3] at t = 4, from the outside
  point (-1.5 0.5 0)
  normal (0 0 1)
  (bound)
  mirror ray, throughput (0.5 0.5 0.5)
    from (-1.5 0.5 0) along (0 0 1)
    meets nothing: the background
    = radiance (0.5 0.25 1)
  mirror (0.25 0.125 0.5)
  = radiance (0.25 0.125 0.5)
|}

let tree () =
  write "m.scene" mirrors;
  let trace args = masked (fine ([ "trace"; "m.scene" ] @ args)).out in
  check_text "a ray that escapes" escapes (trace [ "0"; "1" ]);
  let text = trace [ "3"; "1" ] in
  List.iter (mentions text)
    [
      "  mirror ray, throughput (0.5 0.5 0.5)\n";
      "    meets surface 1 [m.scene:8:3] at t = 5, from the outside\n";
      "    = radiance (0 0 0)\n";
    ];
  mentions
    (trace [ "0"; "1"; "--depth"; "0" ])
    "  reflection cut: the path is at its depth\n  mirror (0 0 0)\n";
  mentions
    (trace [ "0"; "1"; "--cutoff"; ".6" ])
    "  reflection cut: throughput below the cut-off\n"

let lights () =
  let text = (fine [ "trace"; "s.scene"; "12"; "9" ]).out in
  List.iter (mentions text)
    [
      "shadow ray to the light [s.scene:8:3]: ";
      "ambient (";
      "direct light (";
      "mirror (";
    ];
  Alcotest.(check bool)
    "no shadow ray where none is wanted" false
    (contains text "shadow ray to the light [s.scene:9:3]")

(* What it says of a pixel's only sample is what the picture shows there. *)
let agrees () =
  ignore
    (fine [ "render"; "s.scene"; "-o"; "a.pfm"; "--spp"; "1"; "--quiet" ]
      : ended);
  let picture = Test_render.linear "a.pfm" in
  List.iter
    (fun (x, y) ->
      let text =
        (fine
           [
             "trace"; "s.scene"; string_of_int x; string_of_int y; "--spp"; "1";
           ])
          .out
      in
      let lines = String.split_on_char '\n' (String.trim text) in
      let last = List.nth lines (List.length lines - 1) in
      Scanf.sscanf last " = radiance (%f %f %f)" (fun r g b ->
          let c = Candor_image.Picture.pixel picture x y in
          List.iter2
            (fun a b ->
              if Float.abs (a -. b) > 1e-6 *. Float.abs b then
                Alcotest.failf "pixel %d %d: %g and %g" x y a b)
            [ r; g; b ] [ c.r; c.g; c.b ]))
    [ (0, 0); (12, 9); (12, 12); (23, 17); (5, 11) ]

let samples () =
  let first sample =
    (fine [ "trace"; "s.scene"; "3"; "3"; "--sample"; sample ]).out
  in
  mentions (first "2") "pixel 3 3, sample 2 of 4\n";
  Alcotest.(check bool)
    "another ray" false
    (String.equal (first "1") (first "2"));
  check_text "the same again" (first "1") (first "1")

(* Where the textbook's point and Candor's are the same, only what is known of
   its error differs. *)
let naive () =
  write "m.scene" mirrors;
  let trace args = (fine ([ "trace"; "m.scene"; "0"; "1" ] @ args)).out in
  let text = trace [ "--naive-math" ] in
  check_text "the same tree" (masked (trace [])) (masked text);
  mentions text "  the true surface is within 0 of the point\n";
  let far =
    {|(scene
  (image (size 1 1))
  (camera (orthographic (eye 0 0 1e9) (look-at 0 0 0) (height 1)))
  (render (spp 1))
  (sphere (center 0 0 0) (radius 1)))
|}
  in
  write "far.scene" far;
  let trace args = (fine ([ "trace"; "far.scene"; "0"; "0" ] @ args)).out in
  mentions (trace []) " at t = 999999999, ";
  mentions (trace [ "--naive-math" ]) " at t = 1000000000, "

let suite =
  ( "trace",
    [
      example "the golden tree of a mirror, and what is cut" tree;
      with_scene "shadow rays and terms" lights;
      with_scene "the last line is the picture's pixel" agrees;
      with_scene "each sample has its own ray" samples;
      example "--naive-math traces by the textbook, whose error is not known"
        naive;
    ] )
