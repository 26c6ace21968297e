open Candor_oracle
open Candor_scene_made
open Candor_cost

let room =
  Written.scene
    [
      "(image (size 60 40))";
      Written.wide_camera;
      "(background .2) (indirect-light)";
      "(light (point (at 2 3 5) (intensity 40)))";
      "(sphere (center 0 0 0) (radius 1) (material (glass (index 1.5))))";
      "(quadric (plane (normal 0 1 0) (offset -1)))";
    ]

let spp (r : Survey.rung) = r.spp

(* Slow machines get less far; none gets this wrong. *)
let ladder () =
  match Made.survey room with
  | None -> Alcotest.fail "nothing was measured"
  | Some s ->
      let rungs = List.map spp s.rungs in
      let expected = List.init 13 (fun i -> 1 lsl i) in
      let first n = List.filteri (fun i _ -> i < n) expected in
      Alcotest.(check (list int)) "rungs" (first (List.length rungs)) rungs;
      Alcotest.(check int)
        "the finest is the last"
        (spp (List.nth s.rungs (List.length s.rungs - 1)))
        (spp (Survey.finest s));
      Alcotest.(check int)
        "all settings are there, or known to be missing"
        (List.length (Variant.others room))
        (List.length s.others + List.length s.missing)

let own_samples () =
  let scene = Written.with_settings (fun s -> { s with spp = 3 }) room in
  match Made.survey scene with
  | None -> Alcotest.fail "nothing was measured"
  | Some s ->
      let rungs = List.map spp s.rungs in
      if List.length rungs > 2 then
        Alcotest.(check (list int))
          "the scene's own is a rung" [ 1; 2; 3 ]
          (List.filteri (fun i _ -> i < 3) rungs);
      Alcotest.(check bool)
        "and what the others are put beside" true
        (match s.base with Some r -> r.spp <= 3 | None -> true)

(* However little time there is, or however much the scene takes. *)
let kept () =
  List.iter
    (fun seconds ->
      let budget = Budget.start seconds in
      let found =
        Survey.run
          {
            scene = { room with width = 4000; height = 3000 };
            domains = 1;
            budget;
            stop = (fun () -> false);
            progress = ignore;
          }
      in
      let spent = Budget.spent budget in
      if spent > (1.1 *. seconds) +. 0.2 then
        Alcotest.failf "%g s of %g s" spent seconds;
      match found with
      | None -> Alcotest.fail "nothing was measured"
      | Some s ->
          Alcotest.(check bool) "a rung" true (s.rungs <> []);
          Alcotest.(check int) "the first" 1 (spp (List.hd s.rungs)))
    [ 1e-6; 0.001; 0.03; 0.3 ]

let stopped () =
  Alcotest.(check bool)
    "nothing" true
    (Option.is_none (Made.survey ~stop:(fun () -> true) room))

let bare () =
  let scene = Written.scene [ "(image (size 3 2))"; Written.flat_camera ] in
  match Made.survey ~seconds:0.3 scene with
  | None -> Alcotest.fail "nothing was measured"
  | Some s -> Alcotest.(check int) "all pixels" 6 (Subset.count s.subset)

let suite =
  ( "survey",
    [
      Law.example "the ladder doubles its samples" ladder;
      Law.example "the scene's own samples are a rung" own_samples;
      Law.example "the budget is kept, and something is measured" kept;
      Law.example "what is stopped says nothing" stopped;
      Law.example "a scene of nothing can be measured" bare;
    ] )
