open Candor_effect
open Candor_oracle

let floor = "(box (min -9 -9 0) (max 9 9 0))"
let light = "(light (point (at 0 0 4) (intensity 1)))"

let reaches forms (x, y) =
  let s = Lit.scene (floor :: forms) in
  let reach = Shadows.reach (Lit.tracer s) (List.hd s.lights) in
  let tally = Tally.make () in
  let answer =
    reach.surface tally Path.start (Lit.hit s (x, y, 0.5) (0., 0., -1.))
  in
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

(* A light that stands exactly on a surface is seen from all of that side, right
   down to where the surface ends; what it stands on hides it from the other. *)
let on_a_surface =
  let across =
    let beside e = e -. (7. /. 3.) in
    QCheck2.Gen.oneof
      [
        Draw.uniform (-8.) 8.;
        QCheck2.Gen.map beside (Draw.signed (Draw.wide (-15.) (-1.)));
      ]
  in
  let standing name ~at surface ~seen ~hidden =
    let reaches =
      let light = Printf.sprintf "(light (point (at %s) (intensity 1)))" at in
      let s = Lit.scene [ floor; light; surface ] in
      let reach = Shadows.reach (Lit.tracer s) (List.hd s.lights) in
      fun (x, y) ->
        reach.surface (Tally.make ()) Path.start
          (Lit.hit s (x, y, 0.5) (0., 0., -1.))
    in
    Law.law ~count:500
      ~print:(fun (x, y) -> Printf.sprintf "%h %h" x y)
      ("a light exactly on " ^ name ^ " is seen from there alone")
      QCheck2.Gen.(pair across (Draw.uniform (-8.) 8.))
      (fun at ->
        let lit = reaches at in
        (lit || not (seen at)) && ((not lit) || not (hidden at)))
  in
  let everywhere _ = true and nowhere _ = false in
  let can = "(from 0 0 4) (to 0 0 6) (radius 1)" in
  let closed = Printf.sprintf "(quadric (cylinder %s) (caps))" can in
  [
    (* Its plane there meets the floor where 3x = -7. *)
    standing "a ball" ~at:"3 0 4" "(sphere (center 0 0 8) (radius 5))"
      ~seen:(fun (x, _) -> Float.fma 3. x 7. > 0.)
      ~hidden:(fun (x, _) -> x < -2.3334);
    standing "a can's cap" ~at:".25 .5 4" closed ~seen:everywhere
      ~hidden:nowhere;
    standing "a can's rim" ~at:"1 0 4" closed ~seen:everywhere ~hidden:nowhere;
    standing "a can's side" ~at:"1 0 5" closed
      ~seen:(fun (x, _) -> x > 1.0001)
      ~hidden:(fun (x, _) -> x < 0.9999);
    standing "a triangle's corner" ~at:"0 0 4"
      "(triangle (0 0 4) (1 0 6) (0 1 6))" ~seen:everywhere ~hidden:nowhere;
    standing "a box's corner" ~at:".1 .2 4.1"
      "(box (min .1 .2 4.1) (max 1 1 6))" ~seen:everywhere ~hidden:nowhere;
  ]

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
        (s, Shadows.reach (Lit.tracer s) (List.hd s.lights)))
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
        (fun (s, (reach : Direct.reach)) ->
          reach.surface (Tally.make ()) Path.start
            (Lit.hit s (x, y, 1e3) (0., 0., -1.)))
        scenes)

let suite =
  ( "shadows",
    on_a_surface
    @ [
        Law.example
          "what is between a point and the light blocks it, nothing else" point;
        Law.example "the edge of a ball's shadow is where geometry has it" edge;
        Law.example "directional lights are infinitely far" directional;
        own_surface;
      ] )
