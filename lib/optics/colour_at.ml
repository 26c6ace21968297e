open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene

(* The axis that a flat surface leaves out of a pattern: across the surface,
   rounding would decide the colour. *)
let left_out (local : Local.t) =
  if not local.flat then -1
  else
    let { Vec.x; y; z } = (local.normal :> Vec.t) in
    let x = Float.abs x and y = Float.abs y and z = Float.abs z in
    if x >= y && x >= z then 0 else if y >= z then 1 else 2

(* Whether the number of the cell along one axis is odd. *)
let odd scale x = Float.rem (Float.floor (x /. scale)) 2. <> 0.

let rec v (texture : Texture.t) (local : Local.t) =
  match texture with
  | Constant c -> c
  | Checker { even; odd = other; scale } ->
      let skip = left_out local in
      let odd axis = axis <> skip && odd scale (Point.get local.point axis) in
      if odd 0 <> odd 1 <> odd 2 then v other local else v even local
  | Noise { first; second; scale; octaves } ->
      let { Point.x; y; z } = local.point in
      let p = Point.v (x /. scale) (y /. scale) (z /. scale) in
      let mix = Noise.mix ~octaves p in
      Rgb.add
        (Rgb.scale (1. -. mix) (v first local))
        (Rgb.scale mix (v second local))
  | Image { texels; _ } -> (
      match Lazy.force local.uv with
      | Some (u, v) -> Texels.bilinear_repeating texels ~u ~v
      | None -> Rgb.black)
