open Candor_space
open Candor_scene
open Decode
open Fields

let image =
  let size = Quantity.wholes "W H" ~min:1 ~max:65536 in
  fields
    (let+ size = field "size" size in
     (size.(0), size.(1)))

let filters : (string * Scene.filter) list = [ ("box", Box); ("tent", Tent) ]

let duration =
  one "T"
    (atom
       ~expected:(fun () -> "a time")
       (fun notes span a ->
         match Duration.of_string a with
         | Ok t -> Some t
         | Error why -> Notes.refuse notes span (Quote.word a ^ ": " ^ why)))

let render =
  let d = Scene.default_settings in
  fields
    (let+ spp =
       optional "spp" (Quantity.whole "N" ~min:1 ~max:Scene.most_samples)
     and+ depth = optional "depth" (Quantity.whole "N" ~min:0 ~max:0x40000000)
     and+ cutoff =
       default "cutoff" (Quantity.scalar "W" (Rule.within 0. 1.)) d.cutoff
     and+ seed = default "seed" (Quantity.whole "N" ~min:0 ~max:max_int) d.seed
     and+ filter = default "filter" (one "FILTER" (word filters)) d.filter
     and+ error = optional "error" (Quantity.scalar "E" Rule.above_zero)
     and+ time = optional "time" duration in
     let spp =
       match (spp, error, time) with
       | Some spp, _, _ -> spp
       | None, None, None -> d.spp
       | None, _, _ -> Scene.most_samples
     in
     { Scene.spp; depth; cutoff; seed; filter; error; time })

let background =
  let gradient =
    fields
      (let+ down = field "down" Colour_decoder.light
       and+ up = field "up" Colour_decoder.light in
       Scene.Gradient { down; up })
  in
  let image =
    Colour_decoder.radiance
    |> map (fun (file, texels) -> Scene.Image { file; texels })
  in
  Colour_decoder.light_or "background"
    [ ("gradient", gradient); ("image", image) ]
    (fun colour -> Scene.Uniform colour)

let indirect = flag |> map (fun () place -> place) |> placed

let not_flat (b : Bounds.t) =
  if b.x0 < b.x1 && b.y0 < b.y1 && b.z0 < b.z1 then Ok b
  else Error "min must be below max on every axis"

let fog =
  fields
    (let+ extinction = field "extinction" Colour_decoder.light
     and+ albedo = field "albedo" Colour_decoder.reflectance
     and+ anisotropy = Material_decoder.anisotropy
     and+ within = optional "within" (check not_flat Geometry_decoder.bounds) in
     { Scene.extinction; albedo; anisotropy; within })
  |> map (fun value place -> { Scene.value; place })
  |> placed
