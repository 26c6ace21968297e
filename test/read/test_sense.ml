open Candor_read
open Text

let glows = "(material (emitter (radiance 1)))"
let plane = Printf.sprintf "(quadric (plane (normal 0 1 0) (offset 0)) %s)"
let plain_plane = plane ""
let refuses name expected forms = errors name expected (scene ("\n" ^ forms))
let accepts name forms = fine name (scene forms)
let no_bounds = "a surface without bounds may not emit light"

let nearest () =
  accepts "the nearest group's material counts"
    (Printf.sprintf "(group %s (group (material (mirror)) %s))" glows
       plain_plane);
  refuses "whatever is around it"
    [ "2:51 " ^ no_bounds ]
    (Printf.sprintf "(group (material (mirror)) (group %s %s))"
       "(material lamp)" plain_plane
    ^ " (material lamp (emitter (radiance 1)))");
  accepts "its own comes first"
    (Printf.sprintf "(group %s %s)" glows (plane "(material (mirror))"))

let defined () =
  let definition = "\n(define floor (group " ^ plain_plane ^ "))" in
  accepts "a definition without a lamp" ("(use floor)" ^ definition);
  refuses "a use that makes it one"
    [ "3:22 " ^ no_bounds ]
    (Printf.sprintf "(use floor) (use floor %s)" glows ^ definition);
  refuses "a use within a definition"
    [ "3:22 " ^ no_bounds ]
    (Printf.sprintf "(define room (use floor)) (group %s (use room))" glows
    ^ definition);
  refuses "in a definition by itself"
    [ "3:11 " ^ no_bounds ]
    ("(use a)\n(define a " ^ plane glows ^ ")");
  accepts "in a definition that nothing uses" ("(define a " ^ plane glows ^ ")")

let with_others () =
  refuses "beside a name that means nothing"
    [
      "2:60 no definition is called `ice`";
      "2:64 (ambient ...) stands in for what (indirect-light) simulates: give \
       one";
    ]
    "(sphere (center 0 0 0) (radius 1) (material (mirror)))(use ice)(ambient \
     1)(indirect-light)"

let cycles () =
  refuses "a cycle"
    [
      "2:9 a definition contains itself: `a` -> `b` -> `a`"; "3:20 " ^ no_bounds;
    ]
    (Printf.sprintf "(define a (use b))\n(define b (use a %s) %s)(use a %s)" ""
       plain_plane glows)

let fog () =
  let fog = "(fog (extinction .1) (albedo 1))" in
  let within =
    "(fog (extinction .1) (albedo 1) (within (min 0 0 0) (max 1 1 1)))"
  in
  let sun = "(light (directional (direction 0 -1 0) (irradiance 1)))" in
  let lamp = "(light (point (at 0 5 0) (intensity 1)))" in
  accepts "fog and a lamp" (fog ^ lamp ^ "(background 0)");
  accepts "fog within bounds" (within ^ sun ^ "(background 1)");
  accepts "a gradient of black" (fog ^ "(background (gradient (down 0) (up 0)))");
  let background = "fog without bounds leaves nothing of the background" in
  refuses "a background" [ "2:1 " ^ background ] (fog ^ "(background .1)");
  refuses "a gradient"
    [ "2:1 " ^ background ]
    (fog ^ "(background (gradient (down 0) (up (rgb 0 0 .1))))");
  refuses "a sun"
    [ "2:33 fog without bounds leaves nothing of a directional light" ]
    (fog ^ sun)

let energy () =
  let message = "2:18 color + mirror must be at most 1 with indirect light" in
  let check name color mirror expected =
    let glazed =
      Printf.sprintf "(indirect-light) "
      ^ Printf.sprintf
          "(sphere (center 0 0 0) (radius 1) (material (glazed (color %s) \
           (mirror %s))))"
          color mirror
    in
    refuses name expected glazed
  in
  check "all ten tenths" ".7" ".3" [];
  check "exactly" "1" "0" [];
  check "an ulp more" "0x1.0000000000002p-1" ".5" [ message ];
  check "red" "(rgb .6 0 0)" "(rgb .5 0 0)" [ message ];
  check "green" "(rgb 0 .6 0)" "(rgb 0 .5 0)" [ message ];
  check "blue" "(rgb 0 0 .6)" "(rgb 0 0 .5)" [ message ];
  check "apart" "(rgb .6 0 .5)" "(rgb .4 1 .5)" [];
  check "deep in a texture" "(noise 0 (checker .2 (noise .6 0)))" ".5"
    [ message ];
  accepts "without indirect light"
    "(sphere (center 0 0 0) (radius 1) (material (glazed (color 1) (mirror \
     1))))"

(* A white pixel and a black one. *)
let pixels = "P3 2 1 255 255 255 255 0 0 0"

let with_pixels check =
  Files.with_folder (fun folder ->
      let (_ : string) = Files.write folder "a.ppm" pixels in
      check (fun forms ->
          let path = Files.write folder "a.scene" (scene ("\n" ^ forms)) in
          match Scene_file.read path with
          | Ok _ -> []
          | Error { errors; _ } ->
              List.map
                (fun (e : Error.t) ->
                  Printf.sprintf "%d:%d %s" e.place.line e.place.column
                    e.message)
                errors))

let images () =
  with_pixels (fun messages ->
      let check name expected forms =
        Alcotest.(check (list string)) name expected (messages forms)
      in
      let image = "(material (matte (color (checker 0 (image \"a.ppm\")))))" in
      let message = [ "2:1 this surface has no uv for an image" ] in
      let on surface = Printf.sprintf surface image in
      check "sphere" [] (on "(sphere (center 0 0 0) (radius 1) %s)");
      check "plane" [] (on "(quadric (plane (normal 0 1 0) (offset 0)) %s)");
      check "ellipsoid" message
        (on "(quadric (ellipsoid (center 0 0 0) (radii 1 1 1)) %s)");
      check "metal" message
        "(quadric (ellipsoid (center 0 0 0) (radii 1 1 1)) (material (metal \
         (reflectance (image \"a.ppm\")) (roughness 0))))";
      check "bright pixels under a mirror"
        [ "2:1 color + mirror must be at most 1 with indirect light" ]
        "(sphere (center 0 0 0) (radius 1) (material (glazed (color (image \
         \"a.ppm\")) (mirror .1)))) (indirect-light)";
      check "fog before a picture"
        [ "2:1 fog without bounds leaves nothing of the background" ]
        "(fog (extinction 1) (albedo 0)) (background (image \"a.ppm\"))")

(* Each of many materials meets each of many surfaces, through many
   definitions. *)
let linear () =
  let n = 20000 in
  let each f = String.concat "\n" (List.init n f) in
  let text =
    scene
      (each (fun i -> Printf.sprintf "(define d%d (use d%d))" (i + 1) i)
      ^ "(define d0 "
      ^ each (fun _ -> "(group (group " ^ plain_plane ^ "))")
      ^ ")"
      ^ each (fun i ->
          Printf.sprintf "(use d%d (material (emitter (radiance %d))))" n i))
  in
  let start = Sys.time () in
  let { Error.errors; more } = report text in
  is "found" true (List.length errors + more >= 1);
  is "soon" true (Sys.time () -. start < 5.)

let suite =
  ( "sense",
    [
      case "the nearest material must make sense" nearest;
      case "definitions are judged as they are used" defined;
      case "other errors are told as well" with_others;
      case "cycles end" cycles;
      case "fog that ends nowhere stands alone" fog;
      case "a glazed surface keeps to the light it gets" energy;
      case "images need uv, and count with all their pixels" images;
      case "each use of each definition costs nothing more" linear;
    ] )
