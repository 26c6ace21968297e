open Candor_colour
open Candor_scene
open Candor_optics

let name = "emission"
let meaning = "surfaces that give light are seen shining"
let calls = Reason.materials Material.emits

let radiance (hit : Tracer.hit) =
  let skin : Skin.t = hit.material in
  match hit.side with
  | Outside -> skin.material.emission
  | Inside -> if skin.both_sides then skin.material.emission else Rgb.black

type weigh = Path.t -> Tracer.hit -> float

let term ?weigh () : Term.t =
  match weigh with
  | None -> fun _ _ vertex -> radiance vertex.hit
  | Some weigh ->
      fun _ _ { hit; path; _ } ->
        let light = radiance hit in
        if Rgb.is_black light then Rgb.black
        else Rgb.scale (weigh path hit) light
