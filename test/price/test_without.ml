open Candor_oracle
open Candor_colour
open Candor_scene
open Candor_scene_made
open Candor_effect
open Candor_trace
open Candor_cost

let print = Scene.show

(* Everything that shines taken away, one after the other. *)
let rec dark n scene =
  match Without.lights scene with
  | [] -> Some scene
  | { dark = next; _ } :: _ -> if n = 0 then None else dark (n - 1) next

let is_dark scene =
  let pixel = Pixel.compile scene and tally = Tally.make () in
  let black i =
    let x = i * scene.Scene.width / 5 and y = i * scene.height / 5 in
    Rgb.is_black (Pixel.sample pixel tally ~x ~y ~sample:0)
  in
  List.for_all black (List.init 5 Fun.id)

let all_dark scene =
  match dark 200 scene with None -> false | Some scene -> is_dark scene

let names () =
  let scene =
    Written.scene
      [
        Written.flat_camera;
        "(background .1) (ambient .2)";
        "(light (point (at 0 0 5) (intensity 1)))";
        "(light (point (at 0 0 5) (intensity 0)))";
        "(light (directional (direction 0 0 -1) (irradiance 1)))";
        "(sphere (center 0 0 0) (radius 1) (material (emitter (radiance 1))))";
        "(polygon (0 0 0) (1 0 0) (1 1 0) (0 1 0)";
        "  (material (matte (color .5) (emission 1))))";
      ]
  in
  Alcotest.(check (list (pair string int)))
    "lights and lines"
    [
      ("point light", 4);
      ("directional light", 6);
      ("area light", 7);
      ("area light", 8);
      ("ambient light", 3);
      ("background", 0);
    ]
    (List.map
       (fun { Without.name; place; _ } ->
         (name, if Place.equal place Place.unknown then 0 else place.line))
       (Without.lights scene))

let off e scene = not (Plan.is_on (Plan.without e scene) e)

let total scene =
  List.for_all
    (fun e ->
      off e scene
      &&
      match Without.absent e scene with
      | None -> Effect.equal e Anti_aliasing
      | Some (scene, plan) ->
          let plan = plan scene in
          let pixel = Pixel.compile ~plan scene in
          (not (Plan.is_on plan e))
          && Rgb.is_finite
               (Pixel.sample pixel (Tally.make ()) ~x:0 ~y:0 ~sample:0))
    Effect.all

(* Leaving out what is off anyway changes nothing. *)
let absent_twice scene =
  let plan = Plan.of_scene scene in
  List.for_all
    (fun e -> Plan.is_on plan e || Plan.equal plan (Plan.without e scene))
    Effect.all

let flat () =
  let scene color =
    Written.scene
      [
        Written.flat_camera;
        "(ambient 1) (image (size 8 8))";
        "(sphere (center 0 0 0) (radius 3) (material (matte (color " ^ color
        ^ "))))";
      ]
  in
  let seen scene =
    Pixel.sample (Pixel.compile scene) (Tally.make ()) ~x:3 ~y:3 ~sample:0
  in
  let expect name color expected =
    let flat = Without.textures (scene color) in
    let c = seen flat in
    Alcotest.(check (float 1e-12)) name expected c.g;
    Alcotest.(check bool)
      "no texture is left" false
      (Plan.is_on (Plan.of_scene flat) Textures)
  in
  expect "checker" "(checker .2 .6)" 0.4;
  expect "noise" "(noise .1 .2)" 0.15;
  expect "checker of noise" "(checker (noise 0 1) 1)" 0.75;
  expect "constant" ".3" 0.3

let style = Drawn.Loose

let suite =
  ( "without",
    [
      Law.law ~count:20 ~print "a scene without all its lights is black"
        (Rich.scene style) all_dark;
      Law.example "lights are named with their places" names;
      Law.law ~count:12 ~print "every effect can be left out of every scene"
        (Rich.scene style) total;
      Law.law ~count:100 ~print "what is off can be left out for nothing"
        (Rich.scene style) absent_twice;
      Law.example "textures give way to their mean" flat;
    ] )
