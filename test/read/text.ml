(* Scenes as short texts, and words to say what becomes of them. *)

open Candor_read
open Candor_scene

let camera = "(camera (perspective (eye 0 1 5) (look-at 0 1 0) (fov-y 40)))"

(* A scene of these forms besides a camera. *)
let scene forms = Printf.sprintf "(scene %s %s)" camera forms
let read text = Scene_file.of_string ~name:"test.scene" text

let report text =
  match read text with
  | Ok _ -> { Error.errors = []; more = 0 }
  | Error report -> report

let messages text =
  List.map
    (fun (e : Error.t) ->
      Printf.sprintf "%d:%d %s" e.place.line e.place.column e.message)
    (report text).errors

let show report = Format.asprintf "%a" Error.pp_report report

let ok text =
  match read text with
  | Ok scene -> scene
  | Error report -> Alcotest.fail (show report)

let ok_forms forms = ok (scene forms)

let only_surface forms =
  match (ok_forms forms).surfaces with
  | [ s ] -> s
  | surfaces -> Alcotest.failf "%d surfaces" (List.length surfaces)

let is name expected actual = Alcotest.(check bool) name true (expected = actual)

let errors name expected text =
  Alcotest.(check (list string)) name expected (messages text)

let fine name text = Alcotest.(check (list string)) name [] (messages text)

let same (a : Scene.t) b =
  Scene.equal (Scene.forget_places a) (Scene.forget_places b)

let case name f = Alcotest.test_case name `Quick f

let law ?(count = 200) ?print name gen holds =
  QCheck_alcotest.to_alcotest (QCheck2.Test.make ~count ?print ~name gen holds)
