(* How good price lists are: for each scene a list within a budget, then the
   whole picture at the samples that the list predicts to reach an error, and
   what that took and reached. A machine that does other things in between makes
   its own error: so the pixels that prices are made from are timed again, in
   turns with the whole picture; and the ratio of rays needs no clock. *)

open Candor_scene
open Candor_render
open Candor_trace
open Candor_cost
open Candor_colour
open Candor_image

let domains = Rows.most_domains ()

(* Small enough for whole pictures to take seconds. *)
let shrunk (s : Scene.t) pixels =
  let k =
    Float.min 1.
      (sqrt (float_of_int pixels /. float_of_int (s.width * s.height)))
  in
  let part n = Int.max 8 (int_of_float (k *. float_of_int n)) in
  { s with width = part s.width; height = part s.height }

let with_samples (s : Scene.t) spp seed =
  { s with settings = { s.settings with spp; seed = s.settings.seed + seed } }

type render = {
  picture : Picture.t;
  wall : float;
  work : float;  (** processor time, as if it were shared out evenly *)
  rays : float;  (** for each pixel *)
}

let render scene =
  let pixel = Pixel.compile scene in
  let before = Sys.time () in
  match Render.run ~domains pixel scene with
  | None -> exit 1
  | Some r ->
      {
        picture = r.picture;
        wall = r.seconds;
        work = (Sys.time () -. before) /. float_of_int domains;
        rays =
          float_of_int (Candor_effect.Tally.total_rays r.tally)
          /. float_of_int (scene.width * scene.height);
      }

(* The error of one of two independent pictures, from their difference. *)
let error a b =
  let width = Picture.width a and height = Picture.height a in
  let sum = ref 0. in
  let add x y =
    sum := !sum +. (((Display.encode x -. Display.encode y) ** 2.) /. 2.)
  in
  for y = 0 to height - 1 do
    for x = 0 to width - 1 do
      let p = Picture.pixel a x y and q = Picture.pixel b x y in
      add p.r q.r;
      add p.g q.g;
      add p.b q.b
    done
  done;
  sqrt (!sum /. float_of_int (3 * width * height))

let prices scene ~file ~seconds =
  let budget = Budget.start seconds in
  let stop () = false and progress _ = () in
  Survey.run { scene; domains; budget; stop; progress }
  |> Option.map (Appraisal.v scene ~file ~domains budget)

(* The least error whose price can be paid here. *)
let wanted ~most (p : Price.t) =
  List.fold_left
    (fun best (q : Price.prediction) ->
      if q.seconds <= most && q.spp > 1 then Some q else best)
    None p.predictions

(* What the list's own pixels say now that the whole takes: often enough for half
   a second. *)
let again scene (p : Price.t) (q : Price.prediction) =
  let { Scene.width; height; settings; _ } = scene in
  let subset =
    Subset.make ~width ~height ~seed:settings.seed ~pixels:p.pixels
  in
  let pixel = Pixel.compile (with_samples scene q.spp 0) in
  let stop () = false in
  let each = Subset.share subset *. q.seconds in
  let times = Int.max 1 (Int.min 100 (int_of_float (0.5 /. each))) in
  let once _ =
    match Measure.run ~domains ~stop subset pixel with
    | Some m -> m.seconds
    | None -> nan
  in
  List.fold_left ( +. ) 0. (List.init times once) /. float_of_int times

let report file scene (p : Price.t) (q : Price.prediction) =
  let before = again scene p q in
  let first = render (with_samples scene q.spp 1) in
  let between = again scene p q in
  let second = render (with_samples scene q.spp 2) in
  let after = again scene p q in
  let in_turns = (before +. (2. *. between) +. after) /. 4. in
  let wall = (first.wall +. second.wall) /. 2.
  and work = (first.work +. second.work) /. 2. in
  let reached = error first.picture second.picture in
  let expected = Option.value (Appraisal.error_at p q.spp) ~default:nan in
  let finest = List.nth p.ladder (List.length p.ladder - 1) in
  let rays =
    finest.measure.rays_per_pixel *. float_of_int q.spp
    /. float_of_int finest.spp
  in
  Printf.printf
    "%-20s %6d px to %4d spp in %4.1f s | %5d spp: %6.2f s (%.2f..%.2f), took \
     %6.2f (work %6.2f) ratio %.2f, in turns %.2f, rays %.2f | error <= %4.2f: \
     %5.3f, reached %5.3f ratio %.2f\n\
     %!"
    (Filename.remove_extension (Filename.basename file))
    p.pixels finest.spp p.spent q.spp q.seconds q.low q.high wall work
    (work /. q.seconds) (work /. in_turns)
    ((first.rays +. second.rays) /. (2. *. rays))
    q.error expected reached (reached /. expected)

let one ~pixels ~seconds ~most file =
  match Candor_read.Scene_file.read file with
  | Error _ -> Printf.printf "%s: cannot be read\n" file
  | Ok scene -> (
      let scene = shrunk scene pixels in
      match prices scene ~file ~seconds with
      | None -> Printf.printf "%s: no prices\n" file
      | Some p -> (
          match wanted ~most p with
          | Some q -> report file scene p q
          | None -> Printf.printf "%-20s no error can be paid for\n%!" file))

let scenes folder =
  Sys.readdir folder |> Array.to_list
  |> List.filter (fun name -> Filename.check_suffix name ".scene")
  |> List.sort String.compare
  |> List.map (Filename.concat folder)

let () =
  match Array.to_list Sys.argv with
  | _ :: pixels :: seconds :: most :: names ->
      let pixels = int_of_string pixels
      and seconds = float_of_string seconds
      and most = float_of_string most in
      let files name =
        if Sys.is_directory name then scenes name else [ name ]
      in
      List.iter (one ~pixels ~seconds ~most) (List.concat_map files names)
  | _ -> prerr_endline "prices PIXELS BUDGET MOST-SECONDS SCENE..."
