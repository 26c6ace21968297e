open Candor_colour
open Candor_scene
open Candor_oracle
open Candor_scene_made

let even = Texture.Constant (Rgb.v 0.1 0.2 0.3)
let odd = Texture.Constant (Rgb.v 0.4 0.5 0.6)
let checker even odd scale = Texture.Checker { even; odd; scale }

let every_field () =
  Derived.notices
    (module Texture)
    (checker even odd 2.)
    [
      ("even", checker odd odd 2.);
      ("odd", checker even even 2.);
      ("even and odd", checker odd even 2.);
      ("scale", checker even odd 3.);
      ("constant", even);
      ("within", checker (checker even odd 2.) odd 2.);
      ("scale within", checker (checker even odd 3.) odd 2.);
    ]

let every_part () =
  let constant r g b = Texture.Constant (Rgb.v r g b) in
  Derived.notices
    (module Texture)
    (constant 0.1 0.2 0.3)
    [
      ("red", constant 0.9 0.2 0.3);
      ("green", constant 0.1 0.9 0.3);
      ("blue", constant 0.1 0.2 0.9);
    ]

let greatest () =
  let is name expected t =
    Alcotest.(check bool) name true (Rgb.equal expected (Texture.greatest t))
  in
  let red = Texture.Constant (Rgb.v 0.9 0. 0.) in
  let noise =
    Texture.Noise { first = red; second = odd; scale = 1.; octaves = 2 }
  in
  let texels =
    Texels.init ~width:2 ~height:3 (fun x y ->
        Rgb.v (float_of_int x) (float_of_int y) 0.5)
  in
  is "constant" (Rgb.v 0.1 0.2 0.3) even;
  is "checker" (Rgb.v 0.4 0.5 0.6) (checker odd even 1.);
  is "noise, in a checker" (Rgb.v 0.9 0.5 0.6) (checker even noise 1.);
  is "picture" (Rgb.v 1. 2. 0.5) (Image { file = "some.png"; texels })

let suite =
  ( "textures",
    Derived.laws (module Texture) "textures" (Derived.often Drawn.texture)
    @ [
        Law.example "both colours and the scale of a checker count" every_field;
        Law.example "the greatest colour, part by part" greatest;
        Law.example "each part of a colour counts" every_part;
      ] )
