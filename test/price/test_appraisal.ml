open Candor_oracle
open Candor_scene
open Candor_scene_made
open Candor_effect
open Candor_image
open Candor_cost

let row (p : Price.t) matches =
  match List.find_opt (fun (r : Price.row) -> matches r.setting) p.others with
  | Some r -> r
  | None -> Alcotest.fail "the row is missing"

let light line : Price.setting -> bool = function
  | Without_light { place; _ } -> place.line = line
  | _ -> false

let without e : Price.setting -> bool = function
  | Without_effect { absent; _ } -> Effect.equal absent e
  | _ -> false

let check name expected found = Alcotest.(check bool) name expected found

(* The light on line 4 is behind the wall of line 6, and nothing else stands
   between a light and what it falls on. *)
let behind =
  [
    "(image (size 20 20)) " ^ Written.flat_camera;
    "(light (point (at 1 1 5) (intensity 60)))";
    "(light (point (at 1 1 -5) (intensity 60)))";
    "(ambient .1)";
    "(box (min -9 -9 -1) (max 9 9 0) (material (matte (color (checker .2 \
     .8)))))";
  ]

let says expected name scene wanted =
  Alcotest.(check bool) name true (Made.verdict scene wanted = expected)

let for_nothing = says Price.Paid_for_nothing
let needed = says Price.Needed

let lights () =
  let scene = Written.scene behind in
  for_nothing "one lights nothing" scene (light 4);
  needed "one is needed" scene (light 3);
  let p = Made.prices scene in
  let idle = row p (light 4) and busy = row p (light 3) in
  (match idle.setting with
  | Without_light { place; _ } ->
      Alcotest.(check string) "place" "made.scene:4:1" (Place.to_string place)
  | _ -> Alcotest.fail "no light");
  Alcotest.(check (float 0.)) "no loss" 0. idle.loss;
  if busy.loss < 5. then Alcotest.failf "%g is lost" busy.loss

let effects () =
  let scene = Written.scene behind in
  needed "direct light" scene (without Direct);
  needed "textures" scene (without Textures);
  let front = List.filteri (fun i _ -> i <> 2) behind in
  for_nothing "shadows that fall nowhere" (Written.scene front)
    (without Shadows);
  needed "shadows that fall"
    (Written.scene (front @ [ "(sphere (center 0 0 1) (radius .3))" ]))
    (without Shadows)

(* Lights are chosen at random: a picture without one has other noise. *)
let by_chance () =
  let scene =
    Written.scene
      [
        "(image (size 40 40)) (render (spp 32)) " ^ Written.flat_camera;
        "(sphere (center 2 2 3) (radius .5) (material (emitter (radiance 9))))";
        "(sphere (center 0 0 -9) (radius .5) (material (emitter (radiance 9))))";
        "(box (min -9 -9 -1) (max 9 9 0) (material (glazed (color .5) (mirror \
         .1))))";
      ]
  in
  for_nothing "the one behind the wall" scene (light 4);
  needed "the one in front" scene (light 3)

let room =
  [
    "(image (size 40 30))";
    Written.wide_camera;
    "(light (point (at 2 3 5) (intensity 40)))";
    "(background .4)";
    "(sphere (center 0 0 0) (radius 1) (material (mirror)))";
    "(quadric (plane (normal 0 1 0) (offset -1)))";
  ]

let consistent () =
  let scene = Written.scene room in
  let p = Made.prices scene in
  let ladder = p.ladder in
  Alcotest.(check (pair int int)) "size" (40, 30) (p.width, p.height);
  Alcotest.(check int) "views" (List.length ladder) (List.length p.views);
  Alcotest.(check int)
    "pixels" p.pixels
    (Plane.width p.time * Plane.height p.time);
  Alcotest.(check (float 1e-9)) "mean of samples" 1. (Plane.mean p.samples);
  let points =
    List.map
      (fun (r : Price.row) ->
        { Front.seconds = r.measure.seconds; error = r.measure.rms })
      (ladder @ p.others)
  in
  Alcotest.(check (list bool))
    "front" (Front.pareto points)
    (List.map (fun (r : Price.row) -> r.pareto) (ladder @ p.others));
  List.iter
    (fun (r : Price.row) ->
      check "seconds" true (r.measure.seconds > 0.);
      check "rays" true (r.measure.rays_per_pixel > 0.);
      check "rms" true (r.measure.rms >= 0.))
    (ladder @ p.others);
  List.iter
    (fun (q : Price.prediction) ->
      check "range" true (q.low <= q.seconds && q.seconds <= q.high))
    p.predictions

(* What nothing is left to chance in has no error at all. *)
let sure () =
  let p =
    Made.prices
      (Written.scene
         [ "(image (size 9 9)) (background .5)"; Written.flat_camera ])
  in
  check "no law" true (p.law = None && p.predictions = [] && p.knee = None);
  List.iter
    (fun (r : Price.row) -> Alcotest.(check (float 0.)) "rms" 0. r.measure.rms)
    (List.filter (fun (r : Price.row) -> r.spp > 1) p.ladder)

let alone () =
  let p = Made.hurried (Written.scene room) in
  Alcotest.(check int) "one rung" 1 (List.length p.ladder);
  check "of unknown error" true (Float.is_nan (List.hd p.ladder).measure.rms)

let suite =
  ( "appraisal",
    [
      Law.example "a light that lights nothing is named" lights;
      Law.example "so is an effect that changes nothing" effects;
      Law.example "even where noise differs" by_chance;
      Law.example "a list agrees with itself" consistent;
      Law.example "what is exact has no law of errors" sure;
      Law.example "one sample does not know its error" alone;
    ] )
