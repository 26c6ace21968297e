open Candor_space
open Candor_colour
open Candor_scene
open Candor_effect
open Candor_trace
open Candor_oracle
open Candor_scene_made

let rgb = Alcotest.testable (Fmt.of_to_string Rgb.show) Rgb.equal

let radiance s tally =
  let surface = Candor_optics.Skin.surface s in
  Radiance.compile (Plan.compile (Plan.of_scene s) s surface) tally Path.start

let watched (s : Scene.t) ray =
  let seen = ref [] in
  let tally = Tally.make ~watch:(fun e -> seen := e :: !seen) () in
  let value = radiance s tally ray in
  (value, List.rev !seen, tally)

let quiet (s : Scene.t) ray = radiance s (Tally.make ()) ray
let ahead = Ray.v (Point.v 0.1 0.2 5.) (Vec.v 0. 0. (-1.))

let word : Event.t -> string = function
  | Enter { kind; _ } -> "enter " ^ kind
  | Met h -> "met " ^ String.concat "." (List.map string_of_int h.path)
  | Met_nothing -> "met nothing"
  | Shadow { blocked; _ } -> if blocked then "blocked" else "free"
  | Toward_emitter { seen; _ } -> if seen then "lamp met" else "lamp not met"
  | Faces_away _ -> "faces away"
  | Cut Depth -> "cut by depth"
  | Cut Weight -> "cut by weight"
  | Term { name; _ } -> "term " ^ name
  | Leave _ -> "leave"

let glazed =
  [
    Written.flat_camera;
    "(background (rgb .25 .5 1))";
    "(ambient .125)";
    "(light (point (at 0 0 4) (intensity 1)))";
    "(light (point (at 0 0 -4) (intensity 1)))";
    "(box (min -9 -9 0) (max 9 9 0) (material (glazed (color .5) (mirror .5))))";
    "(sphere (center 0 0 2) (radius .001))";
  ]

let events () =
  let s = Written.scene glazed in
  let value, events, tally = watched s ahead in
  Alcotest.(check (list string))
    "what happens"
    [
      "enter camera";
      "met 0";
      "term ambient";
      "free";
      "faces away";
      "term direct light";
      "enter mirror";
      "met nothing";
      "leave";
      "term mirror";
      "leave";
    ]
    (List.map word events);
  Alcotest.check rgb "watching changes nothing" (quiet s ahead) value;
  Alcotest.(check (list int))
    "camera, shadow and mirror rays, no others" [ 1; 1; 1; 0; 0; 0; 0; 0 ]
    (List.map (Tally.get tally) Tally.rays);
  let sum =
    List.fold_left
      (fun sum e ->
        match (e : Event.t) with
        | Term { radiance; _ } -> Rgb.add sum radiance
        | _ -> sum)
      Rgb.black events
  in
  Alcotest.check rgb "the sum of its terms" value sum

let miss () =
  let value, events, _ =
    watched
      (Written.scene [ Written.flat_camera; "(background (rgb .25 .5 1))" ])
      ahead
  in
  Alcotest.check rgb "the background" (Rgb.v 0.25 0.5 1.) value;
  Alcotest.(check (list string))
    "nothing is met"
    [ "enter camera"; "met nothing"; "leave" ]
    (List.map word events)

let same_watched (s : Scene.t) =
  let x = s.width / 2 and y = s.height / 2 in
  let ray = Pixel.ray (Pixel.compile s) ~x ~y ~sample:0 in
  let value, events, tally = watched s ray in
  let entered =
    List.length
      (List.filter (function Event.Enter _ -> true | _ -> false) events)
  and left =
    List.length
      (List.filter (function Event.Leave _ -> true | _ -> false) events)
  and shadows =
    List.length
      (List.filter (function Event.Shadow _ -> true | _ -> false) events)
  and cuts =
    List.length
      (List.filter (function Event.Cut _ -> true | _ -> false) events)
  in
  Rgb.equal value (quiet s ray)
  && entered = left
  && entered = Tally.get tally Camera_rays + Tally.get tally Mirror_rays
  && shadows = Tally.get tally Shadow_rays
  && cuts = Tally.get tally Cut_by_depth + Tally.get tally Cut_by_weight

(* No path is deeper than it may be, and throughput only shrinks. *)
let depths (s : Scene.t) =
  let ray = Pixel.ray (Pixel.compile s) ~x:0 ~y:0 ~sample:0 in
  let _, events, _ = watched s ray in
  let step (open_, ok) (e : Event.t) =
    match e with
    | Enter { throughput; _ } ->
        let ok =
          ok
          && List.for_all
               (fun t -> Rgb.largest throughput <= Rgb.largest t)
               open_
        in
        (throughput :: open_, ok && List.length open_ <= Scene.depth s)
    | Leave _ -> (List.tl open_, ok)
    | _ -> (open_, ok)
  in
  snd (List.fold_left step ([], true) events)

let law name f = Law.law ~count:300 ~print:Drawn.show name (Drawn.scene Round) f

(* A floor that faces a lamp, and one that something stands in front of. *)
let lamps () =
  let words more =
    let scene =
      Written.scene
        ([
           Written.flat_camera;
           "(box (min -9 -9 -1) (max 9 9 0))";
           "(sphere (center 0 0 9) (radius 1) (material (emitter (radiance \
            1))))";
         ]
        @ more)
    in
    let _, events, _ = watched scene ahead in
    List.map word events
  in
  let among w words = List.mem w words in
  Alcotest.(check bool) "met" true (among "lamp met" (words []));
  Alcotest.(check bool)
    "hidden" true
    (among "lamp not met" (words [ "(box (min -2 -2 6) (max 2 2 7))" ]))

let suite =
  ( "radiance",
    [
      Law.example "rays towards lamps are shown" lamps;
      Law.example "the events of a ray, in order, and its terms" events;
      Law.example "a ray that meets nothing brings the background" miss;
      law "watching changes nothing, and events agree with the counters"
        same_watched;
      law "paths are at most as deep as the scene says" depths;
    ] )
