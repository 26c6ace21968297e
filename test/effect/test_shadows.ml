open Candor_scene
open Candor_effect
open Candor_oracle

let floor = "(box (min -9 -9 0) (max 9 9 0))"
let light = "(light (point (at 0 0 4) (intensity 1)))"

let reaches forms (x, y) =
  let s = Lit.scene (floor :: forms) in
  let reach = Shadows.reach (Assembly.surface s) (List.hd s.lights) in
  let tally = Tally.make () in
  let answer = reach tally (Lit.hit s (x, y, 0.5) (0., 0., -1.)) in
  Alcotest.(check int) "one shadow ray" 1 (Tally.get tally Shadow_rays);
  answer

let check name expected forms at =
  Alcotest.(check bool) name expected (reaches forms at)

let ball z r = Printf.sprintf "(sphere (center 0 0 %g) (radius %g))" z r

let point () =
  check "nothing between" true [ light ] (0., 0.);
  check "a ball between" false [ light; ball 2. 0.5 ] (0., 0.);
  check "a ball beside" true [ light; ball 2. 0.5 ] (5., 0.);
  check "a ball behind the light" true [ light; ball 6. 0.5 ] (0., 0.);
  check "the light on a ball's near side" true [ light; ball 5. 1. ] (0., 0.);
  check "the light just inside a ball" false [ light; ball 4.5 0.75 ] (0., 0.);
  check "a light inside of a ball" false [ light; ball 4. 0.25 ] (0., 0.)

(* Seen from the light at height 4, a ball of radius 1 at height 2 hides the disk
   of the floor with radius 4·tan(asin(1/2)). *)
let edge () =
  let radius = 4. *. tan (asin 0.5) in
  let forms = [ light; ball 2. 1. ] in
  check "just within the shadow" false forms (radius -. 1e-9, 0.);
  check "just outside" true forms (radius +. 1e-9, 0.);
  check "within, aside" false forms (0., -.radius +. 1e-9);
  check "outside, aside" true forms (0., -.radius -. 1e-9)

let directional () =
  let sun = "(light (directional (direction 0 0 -3) (irradiance 1)))" in
  check "nothing above" true [ sun ] (0., 0.);
  check "a ball far above" false [ sun; ball 1e6 0.5 ] (0., 0.);
  check "a ball beside" true [ sun; ball 1e6 0.5 ] (0.6, 0.);
  check "what is below does not count" true [ sun; ball (-2.) 0.5 ] (0., 0.)

(* No surface shades itself where it faces the light: every point of a ball. *)
let own_surface =
  let print (x, y) = Printf.sprintf "%h %h" x y in
  let inside =
    QCheck2.Gen.map
      (fun (x, y) -> (x /. 1.5, y /. 1.5))
      (QCheck2.Gen.pair (Draw.uniform (-1.) 1.) (Draw.uniform (-1.) 1.))
  in
  let scenes =
    List.map
      (fun surface ->
        let s =
          Lit.scene
            [
              surface; "(light (directional (direction 0 0 -1) (irradiance 1)))";
            ]
        in
        (s, Shadows.reach (Assembly.surface s) (List.hd s.lights)))
      [
        "(sphere (center 0 0 0) (radius 1))";
        "(sphere (center 0 0 -1e6) (radius 1e6))";
        "(quadric (ellipsoid (center 0 0 0) (radii 1 1 1e-3)))";
        "(quadric (paraboloid (apex 0 0 1) (base 0 0 -5) (radius 9)))";
        "(box (min -1 -1 -1e9) (max 1 1 0.1))";
        "(triangle (-9 -9 0.1) (9 -9 0.3) (0 9 0.7))";
        "(group (transform (rotate (axis 1 2 3) (degrees 40)) (scale 1 2 3)) \
         (sphere (center 0 0 0) (radius 1)))";
      ]
  in
  Law.law ~print "no convex surface is in the way of its own light" inside
    (fun (x, y) ->
      List.for_all
        (fun (s, reach) ->
          reach (Tally.make ()) (Lit.hit s (x, y, 1e3) (0., 0., -1.)))
        scenes)

let suite =
  ( "shadows",
    [
      Law.example
        "what is between a point and the light blocks it, nothing else" point;
      Law.example "the edge of a ball's shadow is where geometry has it" edge;
      Law.example "directional lights are infinitely far" directional;
      own_surface;
    ] )
