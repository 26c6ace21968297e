open Candor_scene
open Candor_effect
open Candor_render
open Candor_trace

let rays (r : Render.report) = Tally.total_rays r.tally

let measure (s : Scene.t) =
  let s = { s with settings = { s.settings with spp = 4 } } in
  let pixel, assembly = Load.timed (fun () -> Pixel.compile s) in
  Option.map (fun r -> (r, assembly)) (Render.run pixel s)

let row folder name =
  let s = Load.named folder name in
  match measure s with
  | None -> ()
  | Some (r, assembly) ->
      let n = float_of_int (rays r) in
      Printf.printf "%-20s %9dx%-5d %8.2f %10.2f %10.2f %12.1f\n%!" name s.width
        s.height assembly (n *. 1e-6)
        (n *. 1e-6 /. r.seconds)
        (r.words /. n)

let table folder =
  Printf.printf "%-20s %15s %8s %10s %10s %12s\n" "scene (4 spp)" "size"
    "build s" "M rays" "M rays/s" "words/ray";
  List.iter (row folder) [ "sphereflake-flat"; "ten-thousand"; "cornell-box" ]
