open Candor_space
open Candor_colour
open Candor_scene

let compile : Scene.background -> Vec.t -> Rgb.t = function
  | Uniform c -> fun _ -> c
  | Gradient { down; up } ->
      fun d ->
        let s = 0.5 *. (1. +. (d.y /. Vec.norm d)) in
        Rgb.add (Rgb.scale (1. -. s) down) (Rgb.scale s up)
  | Image { texels; _ } -> Texels.radiance texels
