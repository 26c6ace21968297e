open Candor_oracle
open Candor_effect
open Candor_scene_made
open Called

let milk = "(translucent (index 1.3) (scattering 3) (absorption .1))"

let calls () =
  check "a surface" Subsurface
    [ camera; ball ("(material " ^ milk ^ ")") ]
    [ ("translucent surface", 3) ];
  check "a material" Subsurface
    [ camera; "(material milk " ^ milk ^ ")"; ball "(material milk)" ]
    [ ("material milk", 3) ];
  check "one that nothing is made of" Subsurface
    [ camera; "(material milk " ^ milk ^ ")"; ball "" ]
    [];
  check "glass" Subsurface [ camera; ball "(material (glass (index 1.5)))" ] []

let reaches ?(moving = false) light =
  let s = Written.scene [ camera; ball ("(material " ^ milk ^ ")"); light ] in
  Subsurface.may_reach ~moving (Lit.tracer s) (List.hd s.lights)

let lamps () =
  let check name expected light =
    Alcotest.(check bool) name expected (reaches light)
  in
  check "a lamp inside" true "(light (point (at .5 0 0) (intensity 1)))";
  check "a lamp outside" false "(light (point (at 1.5 0 0) (intensity 1)))";
  check "in the corner of its box" false
    "(light (point (at .7 .7 .7) (intensity 1)))";
  check "a lamp without shadows" true
    "(light (point (at 1.5 0 0) (intensity 1) (shadows no)))";
  check "a sun" false "(light (directional (direction 1 0 0) (irradiance 1)))";
  Alcotest.(check bool)
    "a lamp among what moves" true
    (reaches ~moving:true "(light (point (at 1.5 0 0) (intensity 1)))")

(* What cannot be reached is not asked: it costs no shadow ray. *)
let rays () =
  let count light =
    let s =
      Written.scene
        [ Written.size 4 4; camera; ball ("(material " ^ milk ^ ")"); light ]
    in
    let { Shot.tally; _ } = Shot.v s in
    Alcotest.(check bool) "it walks" true (Tally.get tally Scattered_rays > 0);
    Tally.get tally Shadow_rays
  in
  Alcotest.(check int)
    "outside" 0
    (count "(light (point (at 1.5 0 0) (intensity 1)))");
  Alcotest.(check bool)
    "inside" true
    (count "(light (point (at .5 0 0) (intensity 1)))" > 0)

let suite =
  ( "subsurface",
    [
      Law.example "translucent surfaces call" calls;
      Law.example "lamps in a body reach it" lamps;
      Law.example "others are not asked" rays;
    ] )
