(* What adaptive sampling is worth: the error of a picture beside that of one
   with the same number of samples in every pixel, in the same time of one
   processor. The errors are those that the pictures tell of themselves. *)

open Candor_scene
open Candor_render
open Candor_trace

let turns = 3

(* In the last, and in focus, what is hard is in a few places. *)
let cases =
  List.map
    (fun name -> (name, 64))
    [
      "hero";
      "mirror";
      "shadows";
      "spot-lights";
      "textures";
      "quadrics";
      "sphereflake";
      "window";
      "lamps";
      "focus";
      "beams";
      "glass";
      "gloss";
      "caustics";
      "overcast";
      "cornell";
      "smallpt";
      "penumbra";
      "keyhole";
    ]

let sized folder name seed =
  let s = Load.named folder name in
  let width = 96 in
  let height = Int.max 1 (width * s.height / s.width) in
  { s with width; height; settings = { s.settings with seed } }

type turn = {
  uniform : float;
  adaptive : float;
  spent : float;  (** time, as a share of the uniform one's *)
  taken : float;  (** samples, likewise *)
}

let rms = function
  | None -> nan
  | Some (r : Render.report) ->
      Option.value (Sampling.rms r.sampling) ~default:nan

let samples r =
  Option.fold ~none:nan
    ~some:(fun (r : Render.report) -> Sample_map.total r.map)
    r

let turn folder name ~spp seed =
  let scene = sized folder name seed in
  let scene = { scene with settings = { scene.settings with spp } } in
  let pixel = Pixel.compile scene in
  let render samples () = Render.run ~domains:1 ~samples pixel scene in
  let seconds, uniform = Turns.processor (render (Uniform spp)) in
  let start = Sys.time () in
  let left () = seconds -. (Sys.time () -. start) in
  let target =
    {
      Adaptive.error = None;
      confidence = 0.95;
      left = Some left;
      most = Scene.most_samples;
    }
  in
  let spent, adaptive = Turns.processor (render (Adaptive target)) in
  {
    uniform = rms uniform;
    adaptive = rms adaptive;
    spent = spent /. seconds;
    taken = samples adaptive /. samples uniform;
  }

let row folder (name, spp) =
  let all = List.init turns (turn folder name ~spp) in
  let median f = Turns.median (List.map f all) in
  Printf.printf "%-14s %4d %9.3f %9.3f %7.2f %7.2f %7.2f\n%!" name spp
    (median (fun t -> t.uniform))
    (median (fun t -> t.adaptive))
    (median (fun t -> t.adaptive /. t.uniform))
    (median (fun t -> t.spent))
    (median (fun t -> t.taken))

let table ~names folder =
  Printf.printf "%-14s %4s %9s %9s %7s %7s %7s\n" "scene" "spp" "uniform"
    "adaptive" "ratio" "time" "samples";
  let wanted (name, _) = names = [] || List.mem name names in
  List.iter (row folder) (List.filter wanted cases)
