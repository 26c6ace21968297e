open Candor_read
open Candor_colour
open Candor_scene
open Text

let defaults () =
  let s = ok_forms "" in
  Alcotest.(check (pair int int)) "image" (640, 480) (s.width, s.height);
  Alcotest.(check bool)
    "background" true
    (Scene.equal_background s.background (Uniform Rgb.black));
  Alcotest.(check bool) "ambient" true (Option.is_none s.ambient);
  Alcotest.(check bool)
    "settings" true
    (Scene.equal_settings s.settings Scene.default_settings);
  Alcotest.(check int) "lights" 0 (List.length s.lights);
  Alcotest.(check int) "surfaces" 0 (List.length s.surfaces)

let settings () =
  let s =
    ok_forms
      "(render (spp 4) (depth 0) (cutoff .5) (seed 7) (filter tent)) (image \
       (size 3 2))"
  in
  Alcotest.(check (pair int int)) "image" (3, 2) (s.width, s.height);
  Alcotest.(check bool)
    "settings" true
    (Scene.equal_settings s.settings
       {
         spp = 4;
         depth = Some 0;
         cutoff = 0.5;
         seed = 7;
         filter = Tent;
         error = None;
         time = None;
       });
  let s = ok_forms "(render (depth 3))" in
  Alcotest.(check bool)
    "only depth" true
    (Scene.equal_settings s.settings
       { Scene.default_settings with depth = Some 3 })

let backgrounds () =
  let check s b =
    Alcotest.(check bool)
      s true
      (Scene.equal_background b (ok_forms s).background)
  in
  check "(background 2)" (Uniform (Rgb.grey 2.));
  check "(background (rgb 1 2 3))" (Uniform (Rgb.v 1. 2. 3.));
  check "(background (gradient (up (rgb 1 2 3)) (down 4)))"
    (Gradient { down = Rgb.grey 4.; up = Rgb.v 1. 2. 3. })

let ambient () =
  match (ok_forms "(ambient (rgb 1 2 3))").ambient with
  | Some { value; place } ->
      Alcotest.(check bool) "value" true (Rgb.equal value (Rgb.v 1. 2. 3.));
      Alcotest.(check string) "place" "test.scene:1:70" (Place.to_string place)
  | None -> Alcotest.fail "no ambient light"

let order () =
  let sphere x = Printf.sprintf "(sphere (center %d 0 0) (radius 1))" x in
  let s = ok_forms (String.concat " " (List.init 100 sphere)) in
  let x i (s : Scene.surface) =
    match s.shape with
    | Sphere s -> s.x = float_of_int i
    | Box _ | Triangle _ | Quadric _ | Polygon _ | Group _ | Mesh _ | Use _ ->
        false
  in
  Alcotest.(check bool)
    "order" true
    (List.for_all Fun.id (List.mapi x s.surfaces))

let design () =
  fine "the example of the design"
    "(scene\n\
    \  (image (size 640 480))\n\
    \  (camera (perspective (eye 0 1 5) (look-at 0 1 0) (up 0 1 0) (fov-y 40)))\n\
    \  (background (rgb .4 .6 .9))\n\
    \  (light (point (at 5 8 5) (intensity (rgb 300 300 300))))\n\
    \  (material floor (matte (color .8)))\n\
    \  (sphere (center 0 1 0) (radius 1) (material (glazed (color (rgb .7 .2 \
     .2)) (mirror .2))))\n\
    \  (quadric (plane (normal 0 1 0) (offset 0)) (material floor)))"

(* Words.top_level is what strays in other forms are compared with. *)
let words () =
  let form = Top_level.form ~include_:(fun _ _ _ t -> t) in
  Alcotest.(check (list string))
    "words"
    (List.sort String.compare Words.top_level)
    (List.sort String.compare (Decode.words form))

let recovery () =
  errors "a wrong definition still defines its name"
    [ "1:84 unknown material `mate`" ]
    (scene
       "(material red (mate)) (sphere (center 0 0 0) (radius 1) (material red))");
  errors "a wrong camera is not a missing one"
    [ "1:16 unknown camera `spective`" ]
    "(scene (camera (spective)))"

let suite =
  ( "top level",
    [
      case "a scene of nothing but a camera has the defaults" defaults;
      case "the picture and how to render it are read" settings;
      case "backgrounds are read" backgrounds;
      case "ambient light is read with its place" ambient;
      case "surfaces keep their order" order;
      case "the example of the design is read" design;
      case "the words of the top level are known as such" words;
      case "one mistake does not lead to another" recovery;
    ] )
