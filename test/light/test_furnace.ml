(* Where the same radiance comes from everywhere, a surface that loses nothing
   cannot be told from what is around it. *)

open Candor_colour
open Candor_oracle
open Candor_scene_made
module Shot = Candor_scene_made.Shot

let colour = Rgb.v 0.75 0.5 0.125
let text = "(rgb .75 .5 .125)"

(* A ball seen off its middle. *)
let ball ?(n = 12) ?spp ?(around = "1") ?(at = ".5 .3 .8") material more =
  [
    Measure.look ~from:"1 2 4" at;
    Measure.settings ?spp n;
    Measure.indirect;
    Printf.sprintf "(background %s)" around;
    Printf.sprintf "(sphere (center 0 0 0) (radius 1) (material %s))" material;
  ]
  @ more

let shown ?n ?spp ?at material more = Measure.v (ball ?n ?spp ?at material more)

let matte () =
  Measure.exactly "matte" colour
    (shown (Printf.sprintf "(matte (color %s))" text) []);
  Measure.exactly ~within:1e-12 "a metal mirror's colour" colour
    (shown (Printf.sprintf "(mirror (color %s))" text) [])

let flats () =
  let flat shape =
    Measure.v
      [
        Measure.look ~from:"1 2 4" "0 0 0";
        Measure.settings 8;
        Measure.indirect;
        "(background 1)";
        Printf.sprintf "(%s (material (matte (color %s))))" shape text;
      ]
  in
  List.iter
    (fun shape -> Measure.exactly shape colour (flat shape))
    [
      "box (min -1 -1 -1) (max 1 1 1)";
      "triangle (-9 -9 0) (9 -9 0) (0 9 0)";
      "quadric (ellipsoid (center 0 0 0) (radii 1 2 3))";
      "quadric (plane (normal 1 1 1) (offset 0))";
    ]

let glazed () =
  Measure.is "glazed"
    (Rgb.add (Rgb.scale 0.5 colour) (Rgb.grey 0.4))
    (shown ~n:24 "(glazed (color (rgb .375 .25 .0625)) (mirror .4))" [])

(* Paths that leave glass without loss bring 1, whichever way they took. *)
let glass () =
  List.iter
    (fun index ->
      let material = Printf.sprintf "(glass (index %s))" index in
      Measure.is
        ("glass of index " ^ index)
        Rgb.white (shown ~spp:8 material []);
      Measure.is
        ("a ball of 1.33 in glass of index " ^ index)
        Rgb.white
        (shown ~spp:8 material
           [
             "(sphere (center 0 .1 0) (radius .5) (material (glass (index \
              1.33))))";
           ]))
    [ "1"; "1.0001"; "1.5"; "2.4"; "0.7" ]

let overlapping () =
  Measure.is "three balls of glass that overlap" Rgb.white
    (shown ~spp:8 "(glass (index 1.5))"
       [
         "(sphere (center .5 .2 .4) (radius .9) (material (glass (index 1.3))))";
         "(box (min 0 0 0) (max 2 2 .9) (material (glass (index 1.9))))";
       ])

let smooth () =
  Measure.exactly "smooth metal of reflectance 1" Rgb.white
    (shown "(metal (reflectance 1) (roughness 0))" []);
  let plastic =
    shown ~n:32 "(plastic (color 1) (index 1.5) (roughness 0))" []
  in
  Measure.is "white smooth plastic" Rgb.white plastic

(* Straight on, what a metal of reflectance 1 loses: the table of
   Candor_optics.Gloss.metal. *)
let rough () =
  let facing =
    [
      Measure.look ~from:"0 0 9" "0 0 0";
      Measure.settings 32;
      Measure.indirect;
      "(background 1)";
    ]
  in
  let metal alpha =
    Measure.v
      (facing
      @ [
          Printf.sprintf
            "(quadric (plane (normal 0 0 1) (offset 0)) (material (metal \
             (reflectance 1) (roughness %g))))"
            alpha;
        ])
  in
  List.iter
    (fun (alpha, loss) ->
      let { Measure.mean; error } = metal alpha in
      let off = Float.abs (1. -. loss -. mean.r) in
      if off > 0.0005 +. (5. *. error.r) then
        Alcotest.failf "roughness %g loses %g, not %g" alpha (1. -. mean.r) loss)
    [ (0.1, 0.012); (0.25, 0.084); (0.5, 0.312); (0.75, 0.536); (1., 0.693) ]

let rough_loses () =
  List.iter
    (fun material ->
      let { Measure.mean; error } = shown ~n:24 material [] in
      if not (mean.r <= 1. +. (5. *. error.r) && mean.r > 0.2) then
        Alcotest.failf "%s returns %g" material mean.r)
    [
      "(metal (reflectance 1) (roughness .05))";
      "(metal (reflectance 1) (roughness .6))";
      "(plastic (color 1) (index 1.5) (roughness .1))";
      "(plastic (color 1) (index 1.5) (roughness .5))";
      "(plastic (color 1) (index 2.5) (roughness 1))";
    ]

(* Glass of index 1 cannot be seen at all: a picture of things behind it. *)
let invisible () =
  let behind =
    [
      Written.size 12 9;
      Written.flat_camera;
      "(background (gradient (down (rgb .1 .2 .3)) (up (rgb .9 .7 .4))))";
      "(ambient .7)";
      "(render (spp 4))";
      "(sphere (center .2 .1 -2) (radius .5) (material (matte (color (checker \
       .6 .2 (scale .3))))))";
    ]
  in
  let picture more = Shot.picture (Written.scene (behind @ more)) in
  Alcotest.check Shot.bits "the same bits" (picture [])
    (picture
       [
         "(sphere (center 0 0 3) (radius .7) (material (glass (index 1))))";
         "(box (min -.3 -.9 1) (max .6 .5 2) (material (glass (index 1))))";
       ])

let suite =
  ( "furnace",
    [
      Law.example "matte and mirror balls return their colour, to rounding"
        matte;
      Law.example "so do matte surfaces of other shapes" flats;
      Law.example "glazed ones return both colours" glazed;
      Law.example "glass of any index cannot be told from the sky, nor nested"
        glass;
      Law.example "nor can bodies of glass that overlap" overlapping;
      Law.example "smooth metal and white plastic lose nothing" smooth;
      Law.example "rough metal loses what its table says" rough;
      Law.example "no rough surface returns more than it gets" rough_loses;
      Law.example "glass of index 1 leaves a picture's bits" invisible;
    ] )
