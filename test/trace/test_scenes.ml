(* The scenes that come with Candor. *)

open Candor_scene
open Candor_effect
open Candor_read
open Candor_oracle
open Candor_scene_made

let folder = Filename.(concat (dirname Sys.executable_name) "../../scenes")

let scenes_in sub =
  match Sys.readdir (Filename.concat folder sub) with
  | files ->
      Array.to_list files
      |> List.filter (fun f -> Filename.check_suffix f ".scene")
      |> List.sort String.compare
      |> List.map (Filename.concat sub)
  | exception Sys_error _ -> []

let files = List.concat_map scenes_in [ ""; "hard" ]

let read file =
  match Scene_file.read (Filename.concat folder file) with
  | Ok s -> s
  | Error report -> Alcotest.failf "%a" Error.pp_report report

let small (s : Scene.t) =
  { s with width = 32; height = 24; settings = { s.settings with spp = 1 } }

let same name a b =
  match Shot.difference a b with
  | None -> ()
  | Some where -> Alcotest.failf "%s: %s" name where

let one file () =
  let s = small (read file) in
  let shot = Shot.v s in
  same "all effects" shot.picture (Shot.picture ~plan:(Plan.all s) s);
  same "2^20 times as large" shot.picture (Shot.picture (Scaled.by 0x1p20 s));
  Alcotest.(check int)
    "samples that are not finite" 0
    (Tally.get shot.tally Non_finite);
  let again =
    Scene_file.of_string
      ~name:(Filename.concat folder file)
      (Scene_printer.to_string s)
  in
  match again with
  | Error report -> Alcotest.failf "printed: %a" Error.pp_report report
  | Ok t ->
      Alcotest.(check bool)
        "reads as it was printed" true
        (Scene.equal (Scene.forget_places s) (Scene.forget_places t))

let opens_with_comment () =
  List.iter
    (fun file ->
      let text =
        In_channel.with_open_bin
          (Filename.concat folder file)
          In_channel.input_all
      in
      Alcotest.(check bool)
        (file ^ " says what to look for")
        true
        (String.starts_with ~prefix:";" text))
    files

let suite =
  ( "scenes in scenes/",
    Law.example "each opens with a comment" opens_with_comment
    :: List.map (fun f -> Law.example (f ^ " keeps the laws") (one f)) files )
