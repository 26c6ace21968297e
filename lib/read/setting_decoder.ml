open Candor_scene
open Decode
open Fields

let image =
  let size = Quantity.wholes "W H" ~min:1 ~max:65536 in
  fields
    (let+ size = field "size" size in
     (size.(0), size.(1)))

let filters : (string * Scene.filter) list = [ ("box", Box); ("tent", Tent) ]

let render =
  let d = Scene.default_settings in
  fields
    (let+ spp = default "spp" (Quantity.whole "N" ~min:1 ~max:0x40000000) d.spp
     and+ depth =
       default "depth" (Quantity.whole "N" ~min:0 ~max:0x40000000) d.depth
     and+ cutoff =
       default "cutoff" (Quantity.scalar "W" (Rule.within 0. 1.)) d.cutoff
     and+ seed = default "seed" (Quantity.whole "N" ~min:0 ~max:max_int) d.seed
     and+ filter = default "filter" (one "FILTER" (word filters)) d.filter
     and+ () = later [ "error"; "time" ] in
     { Scene.spp; depth; cutoff; seed; filter })

let background =
  let gradient =
    fields
      (let+ down = field "down" Colour_decoder.light
       and+ up = field "up" Colour_decoder.light in
       Scene.Gradient { down; up })
  in
  Colour_decoder.light_or "background" ~later:[ "image" ]
    [ ("gradient", gradient) ]
    (fun colour -> Scene.Uniform colour)
