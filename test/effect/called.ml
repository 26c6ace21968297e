(** What calls for effects, and where. *)

open Candor_scene
open Candor_effect
open Candor_scene_made

(** [check name e forms calls]: [calls] are pairs of what calls and the line
    that says so; the first of [forms] is line 2. The plan agrees. *)
let check name e forms calls =
  let s = Written.scene forms in
  let reason (what, line) = Printf.sprintf "%s in line %d" what line in
  let found =
    List.map
      (fun (r : Reason.t) -> reason (r.what, r.place.Place.line))
      (Effect.calls e s)
  in
  Alcotest.(check (list string)) name (List.map reason calls) found;
  Alcotest.(check bool)
    (name ^ ", the plan") (calls <> [])
    (Plan.is_on (Plan.of_scene s) e)

let ball material =
  Printf.sprintf "(sphere (center 0 0 0) (radius 1) %s)" material

let camera = Written.flat_camera

(** [near name expected x] is that [x] is [expected] but for rounding. *)
let near name expected x =
  if not (Lit.close ~within:1e-12 x expected) then
    Alcotest.failf "%s: expected %.17g, got %.17g" name expected x
