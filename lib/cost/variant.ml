open Candor_surface
open Candor_scene
open Candor_sample
open Candor_effect
open Candor_trace

type t = {
  setting : Price.setting;
  scene : Scene.t;
  plan : Scene.t -> Plan.t;
  math : Math.t;
  sampler : Sampler.t;
}

type seeding = First | Second

let setting v = v.setting
let usual = Sampler.Sobol

let v ?(math = Math.Stable) ?(plan = Plan.of_scene) ?(sampler = usual) setting
    scene =
  { setting; scene; plan; math; sampler }

let own scene n = v (Samples n) scene

let lights scene =
  let light { Without.name; place; dark } =
    v (Without_light { name; place }) dark
  in
  List.map light (Without.lights scene)

(* Ambient light is among the lights. *)
let effects scene =
  let plan = Plan.of_scene scene in
  let without (absent : Effect.t) =
    match (absent, Plan.status plan absent) with
    | Ambient, _ | _, (Forced | Off) -> None
    | _, Called reasons ->
        let variant (scene, plan) =
          v ~plan (Without_effect { absent; reasons }) scene
        in
        Option.map variant (Without.absent absent scene)
  in
  List.filter_map without Effect.all

let with_settings scene f =
  { scene with Scene.settings = f scene.Scene.settings }

let rec halvings n = if n = 0 then [] else (n / 2) :: halvings (n / 2)

let depths scene =
  let lesser =
    match Plan.depth (Plan.of_scene scene) with
    | Steps { most; _ } -> List.filteri (fun i _ -> i < 3) (halvings most)
    | Unbounded _ -> [ 8; 4; 2 ]
  in
  let at d =
    v (Depth d) (with_settings scene (fun s -> { s with depth = Some d }))
  in
  List.map at lesser

(* Under indirect light paths end by chance instead. *)
let cutoffs (scene : Scene.t) =
  let at w =
    v (Cutoff w) (with_settings scene (fun s -> { s with cutoff = w }))
  in
  match (Plan.depth (Plan.of_scene scene), scene.indirect) with
  | Steps { most; _ }, None when most > 0 ->
      [ 0.004; 0.02 ]
      |> List.filter (fun w -> w > scene.settings.cutoff)
      |> List.map at
  | (Steps _ | Unbounded _), _ -> []

let samplers scene =
  Sampler.all
  |> List.filter (fun sampler -> not (Sampler.equal sampler usual))
  |> List.map (fun sampler -> v ~sampler (Sampler sampler) scene)

let others scene =
  (v ~math:Textbook Naive_math scene :: lights scene)
  @ effects scene @ depths scene @ cutoffs scene @ samplers scene

let second seed = (Key.v ~seed ~x:0 ~y:0 ~sample:0 ~bounce:0 Path :> int)

let compile variant ~spp seeding =
  let scene =
    with_settings variant.scene (fun s ->
        let seed =
          match seeding with First -> s.seed | Second -> second s.seed
        in
        { s with spp; seed })
  in
  Pixel.compile ~plan:(variant.plan scene) ~math:variant.math
    ~sampler:variant.sampler scene
