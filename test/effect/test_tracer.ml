open Candor_oracle
open Candor_effect
open Candor_scene_made

let scene =
  Written.scene
    [
      "(camera (orthographic (eye 0 0 5) (look-at 0 0 0) (height 2) (shutter 0 \
       2)))";
      "(sphere (center 0 0 0) (radius 1) (motion 0 0 1))";
    ]

let at time = { Path.start with journey = { Path.start.journey with time } }
let ray = Lit.ray (0., 0., 5.) (0., 0., -2.)

let check name (tracer : Tracer.t) time expected =
  let tally = Tally.make () in
  (match tracer.nearest tally (at time) ray with
  | None -> Alcotest.failf "%s: nothing is met" name
  | Some hit -> Called.near name expected hit.t);
  let blocked limit = tracer.blocked tally (at time) ~limit ray in
  Alcotest.(check bool)
    (name ^ ", before") false
    (blocked (expected -. 0x1p-40));
  Alcotest.(check bool) (name ^ ", there") true (blocked expected)

let times () =
  let surface = Candor_optics.Skin.surface scene in
  check "at first" (Tracer.moving surface) 0. 2.;
  check "later" (Tracer.moving surface) 1.5 1.25;
  check "still" (Tracer.still surface) 1.5 2.

let suite =
  ("tracers", [ Law.example "see what moves at the path's time" times ])
