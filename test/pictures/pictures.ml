(* Prints how pictures of scenes/ compare with those of the renderers that the
   scenes come from: by the mean of blocks of pixels, in standard errors, and by
   noise at equal samples. Fails if a mean or the noise is off. *)

open Candor_scene
open Candor_render
open Candor_trace

let render (s : Scene.t) ~spp ~seed =
  let settings = { s.settings with spp; seed } in
  let s = { s with settings } in
  match Render.run (Pixel.compile s) s with
  | Some report -> report.picture
  | None -> invalid_arg "stopped"

let pictures scene ~spp ~times =
  List.init times (fun seed -> render scene ~spp ~seed)

let failures = ref 0

let verdict ok =
  if not ok then incr failures;
  if ok then "" else "  FAILED"

(* Of a thousand blocks three are beyond 3 by chance, and tails are heavier than
   the normal distribution's where light comes by rare paths. *)
let compare name (stored : Means.t) pictures =
  let z = Means.scores (Means.of_pictures ~side:stored.side pictures) stored in
  let n = float_of_int (List.length z) in
  let mean = List.fold_left ( +. ) 0. z /. n
  and rms = sqrt (List.fold_left (fun s z -> s +. (z *. z)) 0. z /. n)
  and beyond = List.length (List.filter (fun z -> Float.abs z > 4.) z) in
  let ok =
    Float.abs mean < 5. /. sqrt n *. 3.
    && rms < 1.5
    && float_of_int beyond <= 0.01 *. n
  in
  Printf.printf
    "%-10s %5.0f means: z %+.3f on average, rms %.3f, %d beyond 4%s\n%!" name n
    mean rms beyond (verdict ok)

let noise name ~spp ~most pictures =
  let rms = Means.noise pictures in
  Printf.printf "%-10s %4d spp: rms noise %.4f, wanted at most %.4f%s\n%!" name
    spp rms most
    (verdict (rms <= most))

let read folder name =
  match Candor_read.Scene_file.read (Filename.concat folder name) with
  | Ok scene -> scene
  | Error report ->
      Format.eprintf "%a%!" Candor_read.Error.pp_report report;
      exit 1

(* What Mitsuba 3's path integrator has there with its independent sampler. *)
let mitsuba = [ (16, 0.0445); (64, 0.0224) ]

let () =
  let folder = Sys.argv.(1) in
  let cornell = read folder "cornell.scene" in
  List.iter
    (fun (spp, most) ->
      let pictures = pictures cornell ~spp ~times:2 in
      noise "cornell" ~spp ~most pictures;
      compare "cornell" (Means.read "cornell.means") pictures)
    mitsuba;
  let smallpt = read folder "smallpt.scene" in
  let smallpt = { smallpt with width = 512; height = 384 } in
  compare "smallpt"
    (Means.read "smallpt.means")
    (pictures smallpt ~spp:8 ~times:4);
  if !failures > 0 then exit 1
