open Candor_colour
open Candor_scene
open Candor_oracle

let default () =
  Alcotest.(check bool)
    "matte .5" true
    (Material.equal Material.default
       (Material.v (Matte { color = Constant (Rgb.v 0.5 0.5 0.5) })))

let suite = ("materials", [ Law.example "the default is matte grey .5" default ])
