(* What a render costs now. *)

open Candor_effect
open Candor_image
open Candor_read
open Candor_render
open Candor_trace

let folder = Filename.(concat (dirname Sys.executable_name) "../../scenes")
let path scene = Filename.concat folder (scene ^ ".scene")

let read scene =
  match Scene_file.read (path scene) with
  | Ok s -> s
  | Error report -> Alcotest.failf "%a" Error.pp_report report

let sized scene ~width ~height ~spp =
  let s = read scene in
  { s with width; height; settings = { s.settings with spp } }

(** [scene row] is the scene of [row], at its size. *)
let scene (row : Stored.row) =
  sized row.scene ~width:row.width ~height:row.height ~spp:row.spp

let counts tally =
  List.filter_map
    (fun c ->
      match Tally.get tally c with 0 -> None | n -> Some (Tally.name c, n))
    Tally.counters

let render plan scene =
  match Render.run ~domains:1 (Pixel.compile ~plan scene) scene with
  | None -> Alcotest.fail "the render stopped"
  | Some report -> report

let digest (r : Render.report) =
  Digest.to_hex (Digest.string (Pfm.encode r.picture))

let measured (row : Stored.row) scene =
  let r = render (Plan.of_scene scene) scene in
  {
    row with
    digest = digest r;
    words = int_of_float r.words;
    counts = counts r.tally;
  }

(** [row r] is [r] with everything but instructions measured now, in one domain.
*)
let row row = measured row (scene row)
