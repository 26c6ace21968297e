open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families
open QCheck2

(* {1 Adding up} *)

let cursor (tests, careful) =
  let c = Cursor.v infinity in
  for i = 1 to tests do
    Cursor.tested c;
    (* Said twice, it counts once. *)
    if i <= careful then (
      Cursor.careful c;
      Cursor.careful c)
  done;
  c

let of_queries queries =
  let e = Effort.make () in
  List.iter (fun q -> Effort.add (cursor q) e) queries;
  e

let both e = (Effort.tests e, Effort.careful e)

let total queries =
  List.fold_left (fun (a, b) (c, d) -> (a + c, b + d)) (0, 0) queries

let adds queries = both (of_queries queries) = total queries

let sums parts =
  both (Effort.sum (List.map of_queries parts)) = total (List.concat parts)

let queries =
  let open Gen in
  let query =
    let* tests = int_bound 30 in
    let* careful = int_bound tests in
    return (tests, careful)
  in
  list_size (int_bound 9) query

let show queries =
  String.concat " "
    (List.map (fun (t, c) -> Printf.sprintf "%d/%d" c t) queries)

(* {1 What queries add} *)

let p = Point.v
let v = Vec.v
let ball x = Surface.sphere (Made.sphere (p x 0. 0.) 1.) ()
let two math = Surface.group ~math [| ball 0.; ball 5. |]

let effort ask =
  let e = Effort.make () in
  ask e;
  both e

let nearest s ray e = ignore (Surface.nearest s ~effort:e ray : _ Hit.t option)

let blocked s ray e =
  ignore (Surface.blocked s ~effort:e ~limit:infinity ray : bool)

let through x = Ray.v (p x 0. 9.) (v 0. 0. (-1.))

let counted () =
  let check what expected ask =
    Alcotest.(check (pair int int)) what expected (effort ask)
  in
  let along = Ray.v (p (-9.) 0.25 0.) (v 1. 0. 0.) in
  let grazing = through (1. -. 1e-15) in
  check "one ball" (1, 0) (nearest (ball 0.) (through 0.));
  check "one of two balls" (1, 0) (nearest (two Stable) (through 0.));
  check "neither ball's box" (0, 0) (nearest (two Stable) (through 2.5));
  check "both balls, in doubt where they hide each other" (2, 0) (fun e ->
      nearest (two Stable) along e;
      nearest (two Stable) (through 5.) e);
  check "grazing one" (1, 1) (nearest (two Stable) grazing);
  check "grazing one, blocked" (1, 1) (blocked (two Stable) grazing);
  check "grazing one, by the textbook" (1, 0) (nearest (two Textbook) grazing);
  check "no ray" (0, 0) (nearest (ball 0.) (Ray.v Point.origin Vec.zero));
  check "twice" (2, 2) (fun e ->
      nearest (two Stable) grazing e;
      blocked (two Stable) grazing e)

let same h h' =
  match (h, h') with
  | None, None -> true
  | Some (a : _ Hit.t), Some (b : _ Hit.t) -> a.t = b.t && a.path = b.path
  | None, Some _ | Some _, None -> false

let unseen ({ shapes; ray } : Shapes.scene) =
  let g = Shapes.group shapes and e = Effort.make () in
  same (Surface.nearest g ray) (Surface.nearest g ~effort:e ray)
  && Effort.tests e <= Array.length shapes
  && Effort.careful e <= Effort.tests e

let textbook_is_careless ({ shapes; ray } : Shapes.scene) =
  let g = Surface.group ~math:Textbook (Array.mapi Shapes.surface shapes) in
  let _, careful = effort (nearest g ray) in
  careful = 0

let suite =
  ( "effort",
    [
      Law.law ~count:500 ~print:show "what cursors counted is added" queries
        adds;
      Law.law ~count:500
        ~print:(fun parts -> String.concat " + " (List.map show parts))
        "a sum is all that was counted"
        Gen.(list_size (int_bound 5) queries)
        sums;
      Law.example "queries count tests, and those where doubles did not do"
        counted;
      Law.law ~count:500 ~print:Shapes.show_scene
        "counting changes no answer; no surface is tested twice" Shapes.scene
        unseen;
      Law.law ~count:500 ~print:Shapes.show_scene
        "the textbook is never careful" Shapes.scene textbook_is_careless;
    ] )
