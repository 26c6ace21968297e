open Candor_colour
open Candor_effect
open Candor_image
open Candor_render
open Candor_oracle
open Candor_scene_made

let scene ?(spp = 1) ?(more = []) () =
  Written.scene
    ([
       Written.size 20 10;
       Written.flat_camera;
       Printf.sprintf "(render (spp %d) (depth 2))" spp;
       "(background (rgb .5 2 0))";
       "(light (point (at 0 0 4) (intensity 1)))";
       "(box (min -.45 -.45 0) (max .45 .45 0))";
     ]
    @ more)

let report s = Test_picture.(get (report ~domains:1 s))

(* Timings and allocation depend on the machine. *)
let masked text =
  let mask words =
    let rec go = function
      | "spp" :: rest -> "spp" :: go rest
      | _ :: "s" :: rest -> "T" :: "s" :: go rest
      | _ :: "words/ray" :: rest -> "N" :: "words/ray" :: go rest
      | w :: rest -> w :: go rest
      | [] -> []
    in
    go words
  in
  match String.split_on_char '\n' text with
  | first :: rest ->
      let words = List.filter (( <> ) "") (String.split_on_char ' ' first) in
      String.concat "\n" (String.concat " " (mask words) :: rest)
  | [] -> ""

let confidence = 0.95

let text ?(name = "out.ppm") ?(format = Picture_file.Ppm) s =
  masked (Ledger.text ~name ~format ~confidence s (report s))

let check name expected actual =
  Alcotest.(check string) name (String.concat "\n" expected) actual

let golden () =
  check "one sample"
    [
      "out.ppm 20x10 1 spp T s 216 rays N words/ray";
      "  sampling   unknown: 1 sample a pixel is too few to tell, 4 are enough";
      "  cut-off    0: no path was cut";
      "  numerics   16 of 32 tests needed more than plain doubles; 0 non-finite";
      "  output     184 pixels clamped at 255; 8-bit rounding 0.08/255";
    ]
    (text (scene ()));
  check "linear"
    [
      "out.pfm 20x10 1..2 spp T s 338 rays N words/ray";
      "  sampling   unknown: 2 samples a pixel are too few to tell, 4 are \
       enough";
      "  cut-off    0: no path was cut";
      "  numerics   38 of 76 tests needed more than plain doubles; 0 non-finite";
      "  output     linear radiance in 32-bit floats: nothing is clamped";
    ]
    (text ~name:"out.pfm" ~format:Pfm (scene ~spp:2 ()))

let line n text = List.nth (String.split_on_char '\n' text) n

let cuts () =
  let mirrors w =
    Written.scene
      [
        Written.size 2 1;
        "(camera (orthographic (eye 0 0 1) (look-at 0 0 0) (height .1)))";
        Printf.sprintf "(render (spp 1) (depth 4) (cutoff %g))" w;
        "(box (min -1 -1 0) (max 1 1 0) (material (mirror (color .5))))";
        "(box (min -1 -1 2) (max 1 1 2) (material (mirror (color .5))))";
      ]
  in
  Alcotest.(check string)
    "by depth" "  cut-off    <= 0.00/255   2 paths ended at depth 4"
    (line 2 (text (mirrors 0.)));
  Alcotest.(check string)
    "by weight" "  cut-off    <= 0.00/255   2 paths fell below weight 0.2"
    (line 2 (text (mirrors 0.2)))

let non_finite () =
  let s =
    scene
      ~more:
        (List.init 8 (fun _ ->
             "(light (directional (direction 0 0 -1) (irradiance 1.7e308)))"))
      ()
  in
  let numerics = line 3 (text s) in
  Alcotest.(check string)
    "counted, and where"
    "  numerics   16 of 160 tests needed more than plain doubles; 16 \
     non-finite samples, the first in pixel 8 3: see candor trace SCENE 8 3"
    numerics

let output () =
  let p =
    Picture.init ~width:2 ~height:1 (fun x _ ->
        if x = 0 then Rgb.v 1.5 0.2 0. else Rgb.v 1. 0.5 0.)
  in
  let { Ledger.clamped; rounding } = Ledger.output p in
  Alcotest.(check int) "clamped" 1 clamped;
  let error x =
    let e = 255. *. (x ** (1. /. 2.2)) in
    (e -. Float.round e) ** 2.
  in
  Alcotest.(check (float 1e-12))
    "rounding"
    (sqrt ((error 0.2 +. error 0.5) /. 6.))
    rounding

let json () =
  let s = scene ~spp:2 () in
  let r = report s in
  let j =
    Json_reader.parse
      (Json.to_string (Ledger.json ~confidence s (Plan.of_scene s) r))
  in
  let check path expected =
    Alcotest.(check bool)
      (String.concat "." path) true
      (Json_reader.get path j = expected)
  in
  let total =
    List.fold_left (fun n c -> n + Tally.get r.tally c) 0 Tally.rays
  in
  check [ "rays"; "total" ] (Number (string_of_int total));
  check [ "rays"; "camera" ] (Number "300");
  check [ "image"; "spared_samples" ] (Number "100");
  check [ "rays"; "shadow" ]
    (Number (string_of_int (Tally.get r.tally Shadow_rays)));
  check [ "rays"; "mirror" ] (Number "0");
  check [ "effects"; "mirror" ] (Bool false);
  check [ "effects"; "shadows" ] (Bool true);
  check [ "domains" ] (Number "1");
  check [ "image"; "width" ] (Number "20");
  check [ "image"; "spp" ] (Number "2");
  check [ "ledger"; "numerics"; "non_finite" ] (Number "0");
  check [ "ledger"; "numerics"; "tests" ] (Number "76");
  check [ "ledger"; "numerics"; "careful" ] (Number "38");
  List.iter
    (fun path ->
      match Json_reader.get path j with
      | Number _ -> ()
      | _ -> Alcotest.fail "a number is expected")
    [ [ "seconds" ]; [ "words_per_ray" ]; [ "ledger"; "output"; "rounding" ] ]

(* {1 Errors} *)

let alike =
  Written.scene [ Written.size 4 3; Written.flat_camera; "(background .5)" ]

let adaptive ?left ~error ~most s =
  let target = { Adaptive.error = Some error; confidence; left; most } in
  Test_picture.get
    (Render.run ~domains:1 ~samples:(Adaptive target)
       (Candor_trace.Pixel.compile s)
       s)

let told s r = line 1 (Ledger.text ~name:"" ~format:Ppm ~confidence s r)

let field s r name =
  Json_reader.get
    [ "ledger"; "sampling"; name ]
    (Json_reader.parse
       (Json.to_string (Ledger.json ~confidence s (Plan.of_scene s) r)))

let targets () =
  let check name expected ~met r s =
    Alcotest.(check string) name expected (told s r);
    Alcotest.(check bool) (name ^ ", met") true (field s r "met" = Bool met)
  in
  let zero = "  sampling   0.00/255 rms (95 %: 0.00 .. 0.00)" in
  check "met"
    (zero ^ "   target 0.5 met")
    ~met:true
    (adaptive ~error:0.5 ~most:64 alike)
    alike;
  check "too few"
    "  sampling   unknown: 3 samples a pixel are too few to tell, 4 are \
     enough   target 0.5 missed: out of samples"
    ~met:false
    (adaptive ~error:0.5 ~most:3 alike)
    alike;
  check "no time"
    "  sampling   unknown: no sample in 11 pixels of 12, shown as one nearby   \
     target 0.5 missed: out of time"
    ~met:false
    (adaptive ~left:(fun () -> -1.) ~error:0.5 ~most:64 alike)
    alike

(* Numbers are of the window, whatever stands in for its pixels. *)
let holes () =
  let window = { Window.x0 = 1; y0 = 0; x1 = 3; y1 = 1 } in
  let told counts =
    let map =
      Sample_map.v ~width:4 ~height:3 ~spp:16 (Window.full alike) counts
    in
    let r =
      Render.run ~domains:1 ~window ~samples:(Map map)
        (Candor_trace.Pixel.compile alike)
        alike
    in
    told alike (Test_picture.get r)
  in
  Alcotest.(check string)
    "one" "  sampling   unknown: no sample in 1 pixel of 2, shown as one nearby"
    (told [| [| 4; 4; 0; 4 |]; [| 0; 4; 4; 4 |]; [| 4; 4; 4; 4 |] |]);
  Alcotest.(check string)
    "all"
    "  sampling   unknown: no sample in 2 pixels of 2, shown as one nearby"
    (told [| [| 0; 0; 0; 0 |]; [| 0; 0; 0; 0 |]; [| 0; 0; 0; 4 |] |])

let misjudged () =
  let s = Test_adaptive.lone in
  let r = adaptive ~error:0.01 ~most:(1 lsl 20) s in
  let expected =
    "   target 0.01 missed: parts of the picture misjudged each other"
  in
  if not (String.ends_with ~suffix:expected (told s r)) then
    Alcotest.fail (told s r);
  Alcotest.(check bool) "met" true (field s r "met" = Bool false)

(* The line, its numbers and those for programs say the same. *)
let intervals () =
  let s = scene ~spp:8 () in
  let r = report s in
  let numbers name =
    match field s r name with
    | Number x -> float_of_string x
    | Null | Bool _ | String _ | List _ | Object _ -> Alcotest.fail name
  in
  let rms = numbers "rms" and low = numbers "low" and high = numbers "high" in
  Alcotest.(check bool) "in order" true (0. < low && low < rms && rms < high);
  Alcotest.(check bool) "how sure" true (numbers "confidence" = confidence);
  Alcotest.(check string)
    "as text"
    (Printf.sprintf "  sampling   %.2f/255 rms (95 %%: %.2f .. %.2f)" rms low
       high)
    (told s r);
  let one = scene () in
  Alcotest.(check bool)
    "unknown is null" true
    (List.for_all
       (fun name -> field one (report one) name = Null)
       [ "rms"; "low"; "high" ])

let suite =
  ( "ledgers",
    [
      Law.example "golden texts, timings masked" golden;
      Law.example "paths that were cut are told, with what they may have lost"
        cuts;
      Law.example "samples that are not finite are counted and placed"
        non_finite;
      Law.example "what an 8-bit file loses" output;
      Law.example "the same as JSON" json;
      Law.example "whether a target was met, and why not" targets;
      Law.example "how many pixels of the window have no sample" holes;
      Law.example "parts of a picture may misjudge each other" misjudged;
      Law.example "the error of sampling is told with its interval" intervals;
    ] )
