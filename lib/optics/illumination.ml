open Candor_number
open Candor_space
open Candor_colour
open Candor_scene

type t = { toward : Vec.t; irradiance : Rgb.t }
type source = At of Point.t | Along of Vec.t

let source (l : Light.t) =
  match l.kind with
  | Point { at; _ } | Spot { at; _ } -> At at
  | Directional { direction; _ } -> Along (Vec.neg direction)

let faded (falloff : Light.falloff) intensity toward =
  match falloff with
  | Square -> Rgb.scale (1. /. Vec.dot toward toward) intensity
  | Constant -> intensity

(* The smooth step s^2 (3 - 2s) between the outer and the inner cone. *)
let cone_factor ~cos_inner ~cos_outer cos =
  if cos >= cos_inner then 1.
  else if cos <= cos_outer then 0.
  else
    let s = (cos -. cos_outer) /. (cos_inner -. cos_outer) in
    s *. s *. (3. -. (2. *. s))

let compile (l : Light.t) =
  match l.kind with
  | Point { at; intensity; falloff } ->
      fun p ->
        let toward = Point.sub at p in
        { toward; irradiance = faded falloff intensity toward }
  | Directional { direction; irradiance } ->
      let toward = Vec.neg direction in
      fun _ -> { toward; irradiance }
  | Spot { at; toward = target; intensity; inner; outer; falloff } ->
      let axis = Dir.of_vec_or Dir.z (Point.sub target at) in
      let cos_inner = Angle.cos inner and cos_outer = Angle.cos outer in
      fun p ->
        let toward = Point.sub at p in
        let cos = -.Vec.dot (axis :> Vec.t) toward /. Vec.norm toward in
        let factor = cone_factor ~cos_inner ~cos_outer cos in
        {
          toward;
          irradiance = Rgb.scale factor (faded falloff intensity toward);
        }
