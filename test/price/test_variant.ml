open Candor_oracle
open Candor_scene
open Candor_scene_made
open Candor_trace
open Candor_effect
open Candor_colour
open Candor_cost

let lit =
  [
    "(image (size 8 8))";
    Written.wide_camera;
    "(light (point (at 2 3 5) (intensity 40)))";
    "(sphere (center 0 0 0) (radius 1) (material (mirror)))";
    "(quadric (plane (normal 0 1 0) (offset -1)))";
  ]

let names scene =
  List.map
    (fun v -> Price_text.setting (Variant.setting v))
    (Variant.others scene)

let check_names name expected forms =
  Alcotest.(check (list string)) name expected (names (Written.scene forms))

let listed () =
  check_names "lit and mirrored"
    [
      "naive math";
      "without point light";
      "without direct light";
      "without shadows";
      "without mirror";
      "depth 0";
      "cutoff 0.004";
      "cutoff 0.02";
      "independent sampler";
      "stratified sampler";
    ]
    lit;
  check_names "a depth and a cutoff of its own"
    [
      "naive math";
      "without point light";
      "without direct light";
      "without shadows";
      "without mirror";
      "depth 5";
      "depth 2";
      "depth 1";
      "cutoff 0.02";
      "independent sampler";
      "stratified sampler";
    ]
    ("(sphere (center 3 0 0) (radius 1) (material (mirror)))"
   :: "(render (depth 10) (cutoff .01))" :: lit);
  check_names "light that bounces"
    [
      "naive math";
      "without background";
      "without indirect light";
      "depth 8";
      "depth 4";
      "depth 2";
      "independent sampler";
      "stratified sampler";
    ]
    [
      Written.wide_camera;
      "(background 1) (indirect-light)";
      "(sphere (center 0 0 0) (radius 1))";
    ]

let seen pixel ~sample = Pixel.sample pixel (Tally.make ()) ~x:3 ~y:3 ~sample

let seeded () =
  let scene = Written.scene lit in
  let at seeding = Variant.(compile (own scene 64) ~spp:64 seeding) in
  let ray pixel = Pixel.ray pixel ~x:3 ~y:3 ~sample:7 in
  let own =
    Pixel.compile (Written.with_settings (fun s -> { s with spp = 64 }) scene)
  in
  Alcotest.(check bool) "the scene's own" true (ray (at First) = ray own);
  Alcotest.(check bool) "and others" true (ray (at Second) <> ray own)

(* One with a light less is that, at any number of samples. *)
let less () =
  let scene = Written.scene lit in
  let dark =
    List.find
      (fun v ->
        match Variant.setting v with
        | Price.Without_light _ -> true
        | _ -> false)
      (Variant.others scene)
  in
  let pixel = Variant.compile dark ~spp:16 First in
  for sample = 0 to 15 do
    let c = seen pixel ~sample in
    Alcotest.(check bool) "black" true (Rgb.is_black c)
  done

let renders scene =
  List.for_all
    (fun v ->
      let pixel = Variant.compile v ~spp:2 Second in
      ignore (seen pixel ~sample:1);
      true)
    (Variant.others scene)

let suite =
  ( "variant",
    [
      Law.example "settings are those that say something" listed;
      Law.example "two sets of samples have two seeds" seeded;
      Law.example "a scene without a light lacks it" less;
      Law.law ~count:5 ~print:Scene.show "all settings of any scene render"
        (Rich.scene Loose) renders;
    ] )
