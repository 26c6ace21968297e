(* The scenes in scenes/hard/ and their gallery: the pictures shown there, by
   either math, are the ones that these scenes give. *)

open Candor_scene
open Candor_effect
open Candor_trace
open Candor_image
open Candor_read
open Candor_oracle

let scenes = Filename.(concat (dirname Sys.executable_name) "../../scenes")
let in_scenes parts = List.fold_left Filename.concat scenes parts

let names =
  match Sys.readdir (in_scenes [ "hard" ]) with
  | files ->
      Array.to_list files
      |> List.filter_map (Filename.chop_suffix_opt ~suffix:".scene")
      |> List.sort String.compare
  | exception Sys_error _ -> []

let scene name =
  match Scene_file.read (in_scenes [ "hard"; name ^ ".scene" ]) with
  | Ok s -> s
  | Error report -> Alcotest.failf "%a" Error.pp_report report

let get = function Ok x -> x | Error why -> Alcotest.fail why

(* {1 Pictures, of which one pixel in 64 is looked at} *)

let step = 8

let shown name =
  let file = in_scenes [ "pictures"; "hard-" ^ name ^ ".png" ] in
  let whole =
    get (Png.decode (In_channel.with_open_bin file In_channel.input_all))
  in
  get
    (Raster.init
       ~width:(Raster.width whole / step)
       ~height:(Raster.height whole / step)
       ~maxval:(Raster.maxval whole)
       (fun x y c -> Ok (Raster.sample whole (step * x) (step * y) c)))

let made math tally (s : Scene.t) =
  let pixel = Pixel.compile ~math s in
  Raster.of_picture
    (Picture.init ~width:(s.width / step) ~height:(s.height / step) (fun x y ->
         Pixel.radiance pixel tally ~x:(step * x) ~y:(step * y)))

let rmse a b = (get (Comparison.v (Display a) (Display b))).rmse

(* In units of 1/255. Powers, sines and cosines may differ by an ulp from one
   machine to the next, and noise with them. *)

let close = 0.5
let close_naive = 4.
let apart = 8.

let at_most what most x =
  if not (x <= most) then Alcotest.failf "%s: %.3f is above %g" what x most

let at_least what least x =
  if not (x >= least) then Alcotest.failf "%s: %.3f is below %g" what x least

let judge name () =
  let scene = scene name and tally = Tally.make () in
  let ours = made Stable tally scene
  and naive = made Textbook (Tally.make ()) scene in
  Alcotest.(check int)
    "samples that are not finite" 0
    (Tally.get tally Non_finite);
  at_most "the picture shown" close (rmse ours (shown name));
  at_most "the textbook's" close_naive (rmse naive (shown (name ^ "-naive")));
  at_least "between the two" apart (rmse naive ours)

(* {1 The page} *)

let mentions page name =
  let has part = Alcotest.(check bool) (part ^ " is there") true in
  let within text part =
    let n = String.length part in
    let rec from i =
      i + n <= String.length text
      && (String.equal (String.sub text i n) part || from (i + 1))
    in
    from 0
  in
  List.iter
    (fun part -> has part (within page part))
    [
      "scenes/hard/" ^ name ^ ".scene";
      "hard-" ^ name ^ ".png";
      "hard-" ^ name ^ "-naive.png";
    ]

let gallery () =
  let page =
    In_channel.with_open_bin
      (in_scenes [ ".."; "lib"; "naive.mld" ])
      In_channel.input_all
  in
  Alcotest.(check bool) "there are scenes" true (names <> []);
  List.iter (mentions page) names

let suite =
  ( "scenes in scenes/hard/",
    Law.example "the gallery shows each" gallery
    :: List.map
         (fun name ->
           Law.example
             (name ^ ": as in the gallery, and the textbook's picture is apart")
             (judge name))
         names )
