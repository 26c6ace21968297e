(** Scenes written down in the scene language. *)

open Candor_scene

(** [file ~name text] is the scene [text], called [name] in places; the test
    fails if it is none. *)
let file ~name text =
  match Candor_read.Scene_file.of_string ~name text with
  | Ok scene -> scene
  | Error report -> Alcotest.failf "%a" Candor_read.Error.pp_report report

(** [scene forms] is the scene of these top-level forms, one a line from line 2
    on. *)
let scene forms =
  file ~name:"made.scene" ("(scene\n" ^ String.concat "\n" forms ^ ")")

(** [size w h] is the form for that size. *)
let size = Printf.sprintf "(image (size %d %d))"

(** One sample a pixel, at its centre. *)
let plain = "(render (spp 1))"

(** Looks along −z from z = 5 at the origin; 2 units high. *)
let flat_camera =
  "(camera (orthographic (eye 0 0 5) (look-at 0 0 0) (height 2)))"

(** Looks along −z from z = 5, 90 degrees high. *)
let wide_camera =
  "(camera (perspective (eye 0 0 5) (look-at 0 0 0) (fov-y 90)))"

(** [with_settings f s] is [s] with its settings changed by [f]. *)
let with_settings f (s : Scene.t) = { s with settings = f s.settings }
