open Candor_oracle
open Candor_space
open Candor_colour
open Candor_scene
open Candor_optics
open Candor_effect
open Candor_scene_made
open Called

let under texels (s : Scene.t) =
  { s with background = Image { file = "sky"; texels } }

let white = Texels.init ~width:4 ~height:2 (fun _ _ -> Rgb.white)
let black = Texels.init ~width:4 ~height:2 (fun _ _ -> Rgb.black)

let calls () =
  let check name texels forms expected =
    let s = under texels (Written.scene (camera :: forms)) in
    let found =
      List.map
        (fun (r : Reason.t) -> (r.what, r.place.line))
        (Sky_light.calls s)
    in
    Alcotest.(check (list (pair string int))) name expected found
  in
  let indirect = "(indirect-light)" in
  let why = [ ("background picture under indirect light", 3) ] in
  check "a picture" white [ indirect; ball "" ] why;
  check "without bounces" white [ ball "" ] [];
  check "a black one" black [ indirect; ball "" ] [];
  check "nothing to light" white
    [ indirect; ball "(material (glass (index 1.5)))" ]
    [];
  Called.check "a gradient" Sky_light
    [ camera; indirect; "(background (gradient (down 0) (up 1)))"; ball "" ]
    []

(* Both ways of finding light share it. *)
let weights () =
  let sky = Option.get (Sampled_sky.make white) in
  let up = Vec.v 0. 1. 0. in
  let arriving arrival =
    let journey = { Path.start.journey with arrival } in
    Sky_light.weigh sky { Path.start with journey } up
  in
  let from : Area_lights.vantage =
    { from = Point.origin; departure = Nowhere; time = 0. }
  in
  near "by a mirror" 1. (arriving Sharp);
  let density = Sampled_sky.density sky Dir.y in
  near "as likely" 0.5 (arriving (Spread { density; from }));
  near "three times as likely" 0.9
    (arriving (Spread { density = 3. *. density; from }));
  near "never" 0. (arriving (Spread { density = 0.; from }))

let unasked () =
  let s = under white (Written.scene [ camera ]) in
  Alcotest.check Lit.rgb "in full" Rgb.white
    (Sky_light.radiance s None Path.start (Vec.v 1. 2. 3.));
  Alcotest.(check bool)
    "nothing to sample in the dark" true
    (Option.is_none (Sky_light.sky (under black s)));
  Alcotest.(check bool)
    "nor in a plain sky" true
    (Option.is_none (Sky_light.sky (Written.scene [ camera ])))

let suite =
  ( "sky light",
    [
      Law.example "a picture calls, with something to shine on" calls;
      Law.example "two ways share its light" weights;
      Law.example "where it is not asked it counts in full" unasked;
    ] )
