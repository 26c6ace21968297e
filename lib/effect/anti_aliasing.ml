open Candor_colour
open Candor_scene
open Candor_surface
open Candor_optics

let name = "anti-aliasing"
let meaning = "pixels are the mean of samples, where one does not decide them"

let calls (scene : Scene.t) =
  let { Scene.spp; error; time; _ } = scene.settings in
  let because why = [ Reason.v why Place.unknown ] in
  if spp = 1 || scene.surfaces = [] then []
  else if Option.is_some error then because "as many samples as the error takes"
  else if Option.is_some time then
    because "as many samples as there is time for"
  else because (Printf.sprintf "%d samples a pixel" spp)

type decided = x:int -> y:int -> bool

let none ~x:_ ~y:_ = false

(* Samples are within a pixel of its middle; one more is for rounding. *)
let margin = 2.

(* For each row the columns, first and last, where something may be seen. *)
let busy (scene : Scene.t) views =
  let clamp n x =
    if x <= 0. then 0 else if x >= float_of_int n then n else int_of_float x
  in
  (* Local mutation: filled here and never again. *)
  let first = Array.make scene.height max_int
  and last = Array.make scene.height (-1) in
  let add (v : Aim.view) =
    let left = clamp scene.width (v.left -. margin)
    and right = clamp scene.width (v.right +. margin) in
    for
      y = clamp scene.height (v.top -. margin)
      to Int.min (scene.height - 1) (clamp scene.height (v.bottom +. margin))
    do
      first.(y) <- Int.min first.(y) left;
      last.(y) <- Int.max last.(y) right
    done
  in
  List.iter add views;
  (first, last)

(* Finer parts see more of what is between, and take longer to look at. *)
let depth = 10

let all_known options =
  if List.for_all Option.is_some options then
    Some (List.filter_map Fun.id options)
  else None

let is_clear (scene : Scene.t) =
  match scene.fog with
  | None -> true
  | Some { value; _ } -> Rgb.is_black value.extinction

let background (scene : Scene.t) surface : decided =
  let { Scene.width; height; camera; _ } = scene in
  match scene.background with
  | Gradient _ | Image _ -> none
  | Uniform _ when not (is_clear scene) -> none
  | Uniform _ -> (
      let views =
        List.map
          (Aim.sight camera ~width ~height)
          (Surface.cover surface ~depth)
      in
      match all_known views with
      | None -> none
      | Some views ->
          let first, last = busy scene views in
          fun ~x ~y -> x < first.(y) || last.(y) < x)
