(* What the absence of an effect is worth: a scene that does not call for it, by
   its plan, with that effect compiled in, and with all effects, turn by turn, in
   seconds of one processor. *)

open Candor_scene
open Candor_effect
open Candor_render
open Candor_trace

let turns = 5

(* A scene without the effect, in which it would be asked often. *)
let scene_without : Effect.t -> string = function
  | Shadows -> "shading"
  | Ambient | Smooth_normals -> "sphereflake-flat"
  | Direct | Gloss | Sky_light -> "cornell"
  | Emission | Soft_shadows | Indirect | Fog -> "glazed-floor"
  | Mirror | Depth_of_field | Textures -> "cornell-box"
  | Refraction | Anti_aliasing -> "orthographic"
  | Dispersion | Absorption | Subsurface -> "glass"
  | Motion_blur -> "ten-thousand"

let spp_without : Effect.t -> int = function
  | Anti_aliasing | Direct | Gloss | Sky_light | Dispersion | Absorption
  | Subsurface ->
      1
  | Emission | Ambient | Shadows | Soft_shadows | Mirror | Refraction | Indirect
  | Fog | Depth_of_field | Motion_blur | Textures | Smooth_normals ->
      4

let sized folder e =
  let s = Load.named folder (scene_without e) in
  let settings = { s.settings with spp = spp_without e } in
  { s with width = 160; height = 120; settings }

(* {1 Measuring} *)

type cost = { seconds : float; words : float  (** per ray *) }

let words_per_ray (r : Render.report) =
  r.words /. float_of_int (Tally.total_rays r.tally)

let cost scene pixel =
  let seconds, report =
    Turns.processor (fun () -> Render.run ~domains:1 pixel scene)
  in
  { seconds; words = Option.fold ~none:nan ~some:words_per_ray report }

type turn = { least : cost; one : cost; all : cost }

let measure e (scene : Scene.t) =
  let compile plan = Pixel.compile ~plan:(plan scene) scene in
  let least = compile Plan.of_scene
  and one = compile (Plan.forcing [ e ])
  and all = compile Plan.all in
  let turn _ =
    let least = cost scene least in
    let one = cost scene one in
    { least; one; all = cost scene all }
  in
  List.init turns turn

let row folder e =
  let all = measure e (sized folder e) in
  let median f = Turns.median (List.map f all) in
  let ratio f = median (fun t -> (f t).seconds /. t.least.seconds) in
  Printf.printf
    "%-15s %-17s %7.3f %7.3f %6.2f %7.3f %6.2f %7.1f %7.1f %7.1f\n%!"
    (Effect.name e) (scene_without e)
    (median (fun t -> t.least.seconds))
    (median (fun t -> t.one.seconds))
    (ratio (fun t -> t.one))
    (median (fun t -> t.all.seconds))
    (ratio (fun t -> t.all))
    (median (fun t -> t.least.words))
    (median (fun t -> t.one.words))
    (median (fun t -> t.all.words))

let table folder =
  Printf.printf "%-15s %-17s %7s %14s %14s %23s\n" "" "" "plan" "with it"
    "with all" "words per ray";
  Printf.printf "%-15s %-17s %7s %7s %6s %7s %6s %7s %7s %7s\n" "effect"
    "scene without it" "s" "s" "ratio" "s" "ratio" "plan" "with it" "all";
  List.iter (row folder) Effect.all
