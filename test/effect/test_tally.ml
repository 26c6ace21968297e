open Candor_colour
open Candor_effect
open Candor_oracle

let counts t = List.map (Tally.get t) Tally.counters

let of_list cs =
  let t = Tally.make () in
  List.iter (Tally.count t) cs;
  t

let some = QCheck2.Gen.(list_size (int_bound 20) (Draw.pick Tally.counters))
let show cs = String.concat " " (List.map Tally.show_counter cs)

let law name f =
  Law.law ~count:500
    ~print:(fun (a, b) -> show a ^ " / " ^ show b)
    name
    (QCheck2.Gen.pair some some)
    f

(* A ball met [n] times through its middle, and [k] times by a hair. *)
let of_rays (n, k) =
  let open Candor_space in
  let open Candor_surface in
  let t = Tally.make () in
  let ball =
    match Sphere.make ~center:Point.origin ~radius:1. with
    | Ok s -> Surface.sphere s ()
    | Error why -> Alcotest.fail why
  in
  let ask x =
    let ray = Ray.v (Point.v x 0. 9.) (Vec.v 0. 0. (-1.)) in
    ignore
      (Surface.nearest ball ~effort:(Tally.effort t) ray : unit Hit.t option)
  in
  List.iter ask (List.init n (fun _ -> 0.) @ List.init k (fun _ -> 1. -. 1e-15));
  t

let efforts ((n, k), (n', k')) =
  let both e = Candor_surface.Effort.(tests e, careful e) in
  both (Tally.effort (Tally.sum [ of_rays (n, k); of_rays (n', k') ]))
  = (n + k + n' + k', k + k')

let names () =
  let names = List.map Tally.name Tally.counters in
  Alcotest.(check int)
    "all different" (List.length names)
    (List.length (List.sort_uniq String.compare names));
  Alcotest.(check (list string))
    "rays"
    [
      "camera";
      "shadow";
      "mirror";
      "refraction";
      "bounce";
      "emitter";
      "sky";
      "scattered";
    ]
    (List.map Tally.name Tally.rays)

let totals () =
  let t = Tally.make () in
  List.iteri
    (fun i c ->
      for _ = 0 to i do
        Tally.count t c
      done)
    Tally.counters;
  (* Those that count rays are the first eight. *)
  Alcotest.(check int)
    "of rays only"
    (1 + 2 + 3 + 4 + 5 + 6 + 7 + 8)
    (Tally.total_rays t)

let watching () =
  let seen = ref 0 in
  let t = Tally.make ~watch:(fun _ -> incr seen) () in
  Alcotest.(check bool) "watched" true (Tally.watched t);
  Tally.show t Met_nothing;
  Alcotest.(check int) "seen once" 1 !seen;
  let t = Tally.make () in
  Alcotest.(check bool) "not watched" false (Tally.watched t);
  Tally.show t Met_nothing

let left_out () =
  let t = Tally.make () in
  let check name expected t =
    Alcotest.check Lit.rgb name expected (Tally.left_out t)
  in
  check "nothing yet" Rgb.black t;
  Tally.leave_out t ~carried:(Rgb.v 0.5 1. 0.) (Rgb.v 0.5 0.25 1.);
  Tally.leave_out t ~carried:Rgb.white (Rgb.v 1. 0. 2.);
  check "both" (Rgb.v 1.25 0.25 2.) t;
  check "together" (Rgb.v 2.5 0.5 4.) (Tally.sum [ t; t ]);
  let row = Float.Array.make 5 7. in
  let words = Gc.minor_words () in
  for _ = 1 to 1000 do
    Tally.leave_out t ~carried:Rgb.white Rgb.white;
    Tally.move_left_out t row 1
  done;
  if Gc.minor_words () -. words > 100. then Alcotest.fail "it allocates";
  check "moved" Rgb.black t;
  Alcotest.(check (list (float 0.)))
    "in the row"
    [ 7.; 1008.25; 1007.25; 1009.; 7. ]
    (Float.Array.to_list row);
  Tally.leave_out t ~carried:Rgb.white Rgb.white;
  Tally.start_anew t;
  check "anew" Rgb.black t

let suite =
  ( "tallies",
    [
      law "get says how often something was counted" (fun (a, _) ->
          counts (of_list a)
          = List.map
              (fun c -> List.length (List.filter (Tally.equal_counter c) a))
              Tally.counters);
      law "the sum of tallies counts all of them" (fun (a, b) ->
          counts (Tally.sum [ of_list a; of_list b ]) = counts (of_list (a @ b)));
      Law.law ~count:200
        ~print:(fun ((n, k), (n', k')) ->
          Printf.sprintf "%d, %d / %d, %d" n k n' k')
        "the sum of tallies has the effort of all of them"
        QCheck2.Gen.(
          let some = int_bound 20 in
          pair (pair some some) (pair some some))
        efforts;
      Law.example "the sum of nothing is zero" (fun () ->
          Alcotest.(check bool)
            "zero" true
            (List.for_all (( = ) 0) (counts (Tally.sum []))));
      Law.example "counters have different names; eight count rays" names;
      Law.example "what is left out is weighed, and no word is allocated"
        left_out;
      Alcotest.test_case "rays of all kinds are counted together" `Quick totals;
      Law.example "a watcher sees every event" watching;
    ] )
