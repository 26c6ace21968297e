open Candor_oracle
open Candor_space
open Candor_colour
open Candor_optics
open Candor_effect
open Called

let fog ?(albedo = 0.) e =
  Printf.sprintf "(fog (extinction %g) (albedo %g))" e albedo

let calls () =
  check "fog" Fog [ camera; fog 1. ] [ ("fog", 3) ];
  check "clear fog" Fog [ camera; fog 0. ] [];
  check "no fog" Fog [ camera ] [];
  check "fog that scatters shows lights" Direct
    [ camera; fog 1. ~albedo:1.; "(light (point (at 0 0 0) (intensity 1)))" ]
    [ ("point light", 4) ];
  check "fog that only absorbs does not" Direct
    [ camera; fog 1.; "(light (point (at 0 0 0) (intensity 1)))" ]
    []

let within : Candor_scene.Scene.fog =
  {
    extinction = Rgb.v 0.5 1. 2.;
    albedo = Rgb.grey 0.5;
    anisotropy = 0.;
    within = Some (Bounds.v (Point.v (-1.) (-1.) (-1.)) (Point.v 1. 1. 1.));
  }

let check_share name length (share : Rgb.t) =
  near (name ^ ", red") (exp (-0.5 *. length)) share.r;
  near (name ^ ", green") (exp (-.length)) share.g;
  near (name ^ ", blue") (exp (-2. *. length)) share.b

(* What is left of a light. *)
let veil () =
  let veil from source = Fog.veil within Path.start from source in
  let at x y z = Illumination.At (Point.v x y z) in
  check_share "through" 2. (veil (Point.v (-5.) 0. 0.) (at 5. 0. 0.));
  check_share "up to a light inside" 1.
    (veil (Point.v (-5.) 0. 0.) (at 0. 0. 0.));
  check_share "from inside" 0.5 (veil (Point.v 0.5 0. 0.) (at 5. 0. 0.));
  check_share "all inside" 0.25 (veil (Point.v 0.5 0. 0.) (at 0.25 0. 0.));
  check_share "beside" 0. (veil (Point.v (-5.) 2. 0.) (at 5. 2. 0.));
  check_share "behind the light" 0.
    (veil (Point.v (-5.) 0. 0.) (at (-3.) 0. 0.));
  check_share "on its side" 2. (veil (Point.v (-5.) 1. 0.) (at 5. 1. 0.));
  check_share "to a sun" 1. (veil (Point.v 0. 0. 0.) (Along (Vec.v 0. 7. 0.)));
  check_share "aslant" (sqrt 2.)
    (veil (Point.v 0. 0. 0.) (Along (Vec.v 1. 1. 0.)))

(* In glass there is no fog. *)
let in_glass () =
  let glass =
    Candor_scene.Material.v
      (Glass
         {
           index = 1.5;
           color = Constant Rgb.white;
           absorption = Rgb.black;
           dispersion = None;
         })
  in
  let journey = { Path.start.journey with inside = [ glass ] } in
  let share =
    Fog.veil within
      { Path.start with journey }
      Point.origin
      (At (Point.v 1. 0. 0.))
  in
  Alcotest.check Lit.rgb "all" Rgb.white share

(* Of fog that only absorbs, nothing is left to chance. *)
let absorbing () =
  let segment order =
    Fog.segment { within with albedo = Rgb.black } order (fun _ _ _ ->
        Alcotest.fail "a light was asked")
  in
  let ray = Lit.ray (0., 0., 5.) (0., 0., -3.) in
  List.iter
    (fun order ->
      let found =
        segment order Lit.no_recursion (Tally.make ()) Path.start ray None
          (fun path _ _ ->
            check_share "throughput" 2. path.throughput;
            Rgb.white)
      in
      check_share "the wall" 2. found)
    [ Fog.Once; Again (Roulette { depth = max_int }) ]

let suite =
  ( "fog",
    [
      Law.example "extinction calls" calls;
      Law.example "a light comes through as far as it is in fog" veil;
      Law.example "bodies keep it out" in_glass;
      Law.example "what only absorbs is sure" absorbing;
    ] )
