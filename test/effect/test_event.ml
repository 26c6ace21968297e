open Candor_colour
open Candor_scene
open Candor_effect
open Candor_trace
open Candor_oracle
open Candor_scene_made
open QCheck2

let cuts = [ Event.Depth; Weight ]

let words () =
  Alcotest.(check (list string))
    "shown"
    [ "Event.Depth"; "Event.Weight" ]
    (List.map Event.show_cut cuts);
  Alcotest.(check string)
    "printed" "Event.Weight"
    (Format.asprintf "%a" Event.pp_cut Weight)

let two_cuts () =
  let check a b expected =
    Alcotest.(check bool) "equal" (expected = 0) (Event.equal_cut a b);
    Alcotest.(check int) "order" expected (Event.compare_cut a b)
  in
  check Depth Depth 0;
  check Weight Weight 0;
  check Depth Weight (-1);
  check Weight Depth 1

(* {1 Watched samples} *)

type watched = {
  events : Event.t list;
  radiance : Rgb.t;
  unwatched : Rgb.t;
  tally : Tally.t;
}

let watch (s, (x, y)) =
  let pixel = Pixel.compile s and seen = ref [] in
  let sample tally = Pixel.sample pixel tally ~x ~y ~sample:0 in
  let tally = Tally.make ~watch:(fun e -> seen := e :: !seen) () in
  let radiance = sample tally in
  let unwatched = sample (Tally.make ()) in
  { events = List.rev !seen; radiance; unwatched; tally }

(* What happened between an [Enter] and its [Leave]. *)
type ray = {
  kind : string;
  throughput : Rgb.t;
  own : Event.t list;  (** in order, without what belongs to the rays within *)
  within : ray list;
  brought : Rgb.t;
}

(* The ray that [events] begin with, and the events after it. *)
let rec first_ray (events : Event.t list) =
  match events with
  | Enter { kind; throughput; _ } :: rest ->
      let rec go own within (events : Event.t list) =
        match events with
        | [] -> Law.fail "a ray is never left"
        | Enter _ :: _ ->
            let ray, rest = first_ray events in
            go own (ray :: within) rest
        | Leave { radiance = brought } :: rest ->
            let own = List.rev own and within = List.rev within in
            ({ kind; throughput; own; within; brought }, rest)
        | (( Met _ | Met_nothing | Shadow _ | Toward_emitter _ | Faces_away _
           | Cut _ | Term _ ) as e)
          :: rest ->
            go (e :: own) within rest
      in
      go [] [] rest
  | _ -> Law.fail "something happens, but to no ray"

let only_ray w =
  match first_ray w.events with
  | ray, [] -> ray
  | _, _ :: _ -> Law.fail "something happens after the camera ray"

let rec rays ray = ray :: List.concat_map rays ray.within

let nested w =
  let ray = only_ray w in
  String.equal ray.kind "camera"
  && List.for_all
       (fun r -> not (String.equal r.kind "camera"))
       (List.concat_map rays ray.within)

let met (e : Event.t) =
  match e with
  | Met _ | Met_nothing -> true
  | Enter _ | Shadow _ | Toward_emitter _ | Faces_away _ | Cut _ | Term _
  | Leave _ ->
      false

(* First of all a ray meets something or nothing, and after nothing it ends. *)
let meets_once ray =
  match ray.own with
  | [ Met_nothing ] -> ray.within = []
  | Met _ :: rest -> not (List.exists met rest)
  | _ -> false

let terms ray =
  List.filter_map
    (function Event.Term { radiance; _ } -> Some radiance | _ -> None)
    ray.own

let is_their_sum ray =
  match ray.own with
  | [ Met_nothing ] -> true
  | _ -> Rgb.equal ray.brought (List.fold_left Rgb.add Rgb.black (terms ray))

let is_share (a : Rgb.t) (b : Rgb.t) = a.r <= b.r && a.g <= b.g && a.b <= b.b

let rec fades ray =
  List.for_all
    (fun r -> is_share r.throughput ray.throughput && fades r)
    ray.within

let counted w =
  let number f = List.length (List.filter f w.events) in
  let get = Tally.get w.tally in
  let is_cut c (e : Event.t) =
    match e with Cut d -> Event.equal_cut c d | _ -> false
  in
  number (function Event.Enter _ -> true | _ -> false)
  = get Camera_rays + get Mirror_rays
  && number (function Event.Leave _ -> true | _ -> false)
     = get Camera_rays + get Mirror_rays
  && number (function Event.Shadow _ -> true | _ -> false) = get Shadow_rays
  && number (is_cut Depth) = get Cut_by_depth
  && number (is_cut Weight) = get Cut_by_weight

let place =
  let open Gen in
  let* s = Drawn.scene Round in
  let+ x = int_bound (s.Scene.width - 1)
  and+ y = int_bound (s.Scene.height - 1) in
  (s, (x, y))

let print (s, (x, y)) = Printf.sprintf "pixel %d %d of\n%s" x y (Drawn.show s)

let law name holds =
  Law.law ~count:1000 ~print name place (fun drawn -> holds (watch drawn))

let each name holds = law name (fun w -> List.for_all holds (rays (only_ray w)))

let suite =
  ( "events",
    [
      Law.example "a cut is shown by its name" words;
      Law.example "there are two cuts, depth before weight" two_cuts;
      law "every ray that is entered is left, those within it before" nested;
      each "a ray meets something or nothing, once and first" meets_once;
      each "what a ray brings is the sum of its terms" is_their_sum;
      law "what the camera ray brings is the sample" (fun w ->
          Rgb.equal (only_ray w).brought w.radiance);
      law "watching changes nothing" (fun w -> Rgb.equal w.radiance w.unwatched);
      law "the camera's throughput is 1, and reflections only lessen it"
        (fun w ->
          let ray = only_ray w in
          Rgb.equal ray.throughput Rgb.white && fades ray);
      law "what is shown is what is counted" counted;
    ] )
