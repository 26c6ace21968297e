open Candor_colour
open Candor_scene
open Candor_effect
open Candor_trace
open Candor_image
open Candor_render
open Candor_oracle
open Candor_scene_made

(* {1 Pictures with the mean weight of what was cut} *)

type rendered = { picture : Picture.t; cut : Picture.t; tally : Tally.t }

let rendered (s : Scene.t) =
  let pixel = Pixel.compile s and total = Tally.make () in
  let share = 1. /. float_of_int s.settings.spp in
  let one x y =
    Tally.start_anew total;
    let c = Pixel.radiance pixel total ~x ~y in
    (c, Rgb.scale share (Tally.left_out total))
  in
  let all =
    Array.init s.height (fun y -> Array.init s.width (fun x -> one x y))
  in
  let picture of_ =
    Picture.init ~width:s.width ~height:s.height (fun x y -> of_ all.(y).(x))
  in
  { picture = picture fst; cut = picture snd; tally = total }

let at ?(cutoff = 0.) depth =
  Written.with_settings (fun s -> { s with depth = Some depth; cutoff })

let for_all (s : Scene.t) f =
  List.for_all
    (fun i -> f (i mod s.width) (i / s.width))
    (List.init (s.width * s.height) Fun.id)

let parts f (a : Rgb.t) (b : Rgb.t) (c : Rgb.t) (d : Rgb.t) =
  f a.r b.r c.r d.r && f a.g b.g c.g d.g && f a.b b.b c.b d.b

(* {1 Two mirrors} *)

(* Mirrors that face each other, and glow: what is seen is the sum of e·r^i, of
   which depth n leaves out all from i = n + 1 on. *)
let mirrors =
  let mirror z =
    Printf.sprintf
      "(box (min -1 -1 %g) (max 1 1 %g) (material (mirror (color (rgb .5 .8 \
       .95)) (emission (rgb .1 .02 .01)))) (both-sides))"
      z z
  in
  Written.scene
    [
      Written.size 3 2;
      "(camera (orthographic (eye 0 0 1) (look-at 0 0 0) (height .1)))";
      Written.plain;
      mirror 0.;
      mirror 2.;
    ]

let difference a b =
  let width = Picture.width a in
  let one i =
    let x = i mod width and y = i / width in
    let c = Picture.pixel a x y and d = Picture.pixel b x y in
    let square x y = (Display.encode x -. Display.encode y) ** 2. in
    square c.r d.r +. square c.g d.g +. square c.b d.b
  in
  let pixels = width * Picture.height a in
  let sum = List.fold_left ( +. ) 0. (List.init pixels one) in
  sqrt (sum /. float_of_int (3 * pixels))

let near name expected x =
  if not (Float.abs (x -. expected) <= 1e-9 *. Float.max 1e-3 expected) then
    Alcotest.failf "%s: expected %.17g, got %.17g" name expected x

let attained () =
  let whole = Rgb.v (0.1 /. 0.5) (0.02 /. 0.2) (0.01 /. 0.05) in
  let complete = Picture.init ~width:3 ~height:2 (fun _ _ -> whole) in
  List.iter
    (fun depth ->
      let s = at depth mirrors in
      let { picture; cut; tally } = rendered s in
      let c = Picture.pixel cut 1 1 and n = float_of_int (depth + 1) in
      near "red" (0.5 ** n) c.r;
      near "green" (0.8 ** n) c.g;
      near "blue" (0.95 ** n) c.b;
      Alcotest.(check int) "cut" 6 (Tally.get tally Cut_by_depth);
      match Cut_off.of_picture (Brightest.of_scene s) ~cut picture with
      | Unbounded why -> Alcotest.fail why
      | At_most rms -> near "lost" (difference complete picture) rms)
    [ 0; 1; 2; 5; 20; 60 ]

(* {1 Any scene} *)

(* The same samples followed deeper find no more than what is said to be lost. *)
let bounded s deep =
  let cut = rendered s and whole = rendered deep in
  match Brightest.of_scene s with
  | Unbounded _ -> true
  | At_most most -> (
      for_all s (fun x y ->
          let at p = Picture.pixel p x y in
          parts
            (fun x cut whole most ->
              x <= whole *. (1. +. 1e-12)
              && whole <= (x +. (cut *. most)) *. (1. +. 1e-9))
            (at cut.picture) (at cut.cut) (at whole.picture) most)
      &&
      match Cut_off.of_picture (At_most most) ~cut:cut.cut cut.picture with
      | Unbounded _ -> false
      | At_most rms ->
          difference cut.picture whole.picture <= (rms *. (1. +. 1e-9)) +. 1e-9)

let depths = QCheck2.Gen.int_bound 3

let drawn (s, depth) =
  let cutoff = s.Scene.settings.cutoff in
  bounded (at ~cutoff depth s) (at 30 s)

let law =
  Law.law ~count:300
    ~print:(fun (s, depth) ->
      Printf.sprintf "depth %d: %s" depth (Drawn.show s))
    "no more is lost than the bound says, of any picture"
    (QCheck2.Gen.pair (Drawn.scene Loose) depths)
    drawn

let glass () =
  let s =
    Written.scene
      [
        Written.size 12 9;
        "(camera (perspective (eye 0 2 9) (look-at 0 1 0) (fov-y 30)))";
        "(background (gradient (down .2) (up (rgb .4 .6 1))))";
        "(light (directional (direction -1 -2 -1) (irradiance 2)))";
        "(render (spp 2))";
        "(quadric (plane (normal 0 1 0) (offset 0)) (material (glazed (color \
         .4) (mirror .3))))";
        "(sphere (center 0 1 0) (radius 1) (material (glass (index 1.5) \
         (absorption .1))))";
        "(sphere (center 1.5 1 -2) (radius 1) (material (plastic (color .5) \
         (index 1.5) (roughness 0))))";
      ]
  in
  List.iter
    (fun depth ->
      Alcotest.(check bool)
        (Printf.sprintf "depth %d" depth)
        true
        (bounded (at depth s) (at 10 s)))
    [ 0; 1; 3; 6 ]

(* A ball seen from within, whose wall glows and sends half of its light back:
   all of it has radiance 2. Below the depth, lamps are asked for what the last
   step would have found of the wall's own light, so that much is lost twice. *)
let furnace () =
  let s =
    Written.scene
      [
        Written.size 2 2;
        "(camera (perspective (eye .2 .1 0) (look-at 0 0 -1) (fov-y 60)))";
        "(indirect-light)";
        "(render (spp 256))";
        "(sphere (center 0 0 0) (radius 1) (both-sides) (material (matte \
         (color .5) (emission 1))))";
      ]
  in
  List.iter
    (fun depth ->
      let s = at depth s in
      let { picture; cut; _ } = rendered s in
      let most =
        match Brightest.of_scene s with
        | At_most most -> most.r
        | Unbounded why -> Alcotest.fail why
      in
      near "brightest" 2. most;
      let mean part = (part 0 0 +. part 0 1 +. part 1 0 +. part 1 1) /. 4. in
      let x = mean (fun x y -> (Picture.pixel picture x y).r)
      and cut = mean (fun x y -> (Picture.pixel cut x y).r) in
      let expected = 2. +. (0.5 ** float_of_int (depth + 1)) in
      if Float.abs (x +. (cut *. most) -. expected) > 0.02 then
        Alcotest.failf "depth %d: %g and %g lost, expected %g" depth x
          (cut *. most) expected)
    [ 0; 1; 3; 6; 9 ]

(* {1 Numbers} *)

let squares () =
  let of_ ?(most = Rgb.white) cut x = Cut_off.squares ~most ~cut x in
  let value = Alcotest.(check (float 1e-9)) in
  value "nothing cut" 0. (of_ Rgb.black (Rgb.grey 0.5));
  value "all of black" (3. *. 255. *. 255.) (of_ Rgb.white Rgb.black);
  value "nothing that shows above white" 0. (of_ Rgb.white Rgb.white);
  value "one colour"
    ((Display.encode 0.5 -. Display.encode 0.25) ** 2.)
    (of_ ~most:(Rgb.v 7. 0.5 7.) (Rgb.v 0. 0.5 0.) (Rgb.grey 0.25));
  value "not a number" (255. *. 255.) (of_ (Rgb.v nan 0. 0.) (Rgb.grey 0.25))

let lines () =
  let says name expected ?(bound = Cut_off.At_most 0.0312) cuts =
    let tally = Tally.make () in
    List.iter (Tally.count tally) cuts;
    let s = at ~cutoff:0.2 4 mirrors in
    Alcotest.(check string) name expected (Cut_off.text s tally (lazy bound))
  in
  says "none" "0: no path was cut" [];
  says "rounded up" "<= 0.04/255   1 path ended at depth 4" [ Cut_by_depth ];
  says "both"
    "<= 0.04/255   1 path ended at depth 4, 2 paths fell below weight 0.2"
    [ Cut_by_depth; Cut_by_weight; Cut_by_weight ];
  says "unbounded" "unbounded: 1 path fell below weight 0.2; a lamp is near"
    ~bound:(Unbounded "a lamp is near") [ Cut_by_weight ]

let json () =
  let is name expected tally bound =
    Alcotest.(check string)
      name
      (Json.to_string (Object expected))
      (Json.to_string (Cut_off.json tally (lazy bound)))
  in
  let counts n : (string * Json.t) list =
    [ ("by_depth", Int n); ("by_weight", Int 0) ]
  in
  let tally = Tally.make () in
  is "whole" (("rms", Float 0.) :: counts 0) tally (Unbounded "unasked");
  Tally.count tally Cut_by_depth;
  is "bounded" (("rms", Float 0.5) :: counts 1) tally (At_most 0.5);
  is "unbounded"
    (("rms", Null) :: ("reason", String "why") :: counts 1)
    tally (Unbounded "why")

let suite =
  ( "cut-off",
    [
      Law.example "facing mirrors lose as much as the bound" attained;
      law;
      Law.example "nor of glass and plastic" glass;
      Law.example "nor where light bounces and paths end by chance" furnace;
      Law.example "what a pixel may have lost" squares;
      Law.example "the ledger's line" lines;
      Law.example "the same for programs" json;
    ] )
