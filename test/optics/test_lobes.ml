open Candor_space
open Candor_colour
open Candor_scene
open Candor_optics
open Candor_oracle
open Candor_scene_made

let here = { Drawn.some_point with point = Point.v 1.5 0.5 0.5 }
let red = Rgb.v 0.5 0. 0.
let blue = Rgb.v 0. 0. 0.5

let board =
  Texture.Checker { even = Constant red; odd = Constant blue; scale = 1. }

let dark =
  Texture.Checker
    { even = Constant Rgb.black; odd = Constant Rgb.black; scale = 1. }

let half_dark =
  Texture.Checker { even = Constant Rgb.black; odd = dark; scale = 1. }

let half_lit = Texture.Checker { even = dark; odd = Constant red; scale = 1. }

let check name m ~diffuse ~highlight ~mirror =
  let l = Lobes.of_material m here in
  let rgb = Alcotest.testable Rgb.pp Rgb.equal in
  Alcotest.check rgb (name ^ ", diffuse") diffuse l.diffuse;
  Alcotest.check rgb (name ^ ", mirror") mirror l.mirror;
  Alcotest.(check bool) (name ^ ", highlight") true (l.highlight = highlight)

let lobes () =
  let black = Rgb.black in
  check "matte"
    (Matte { color = board })
    ~diffuse:blue ~highlight:None ~mirror:black;
  check "phong"
    (Phong { color = board; specular = red; shininess = 7. })
    ~diffuse:blue
    ~highlight:(Some { specular = red; shininess = 7. })
    ~mirror:black;
  check "mirror"
    (Mirror { color = board })
    ~diffuse:black ~highlight:None ~mirror:blue;
  check "glazed: the mirror is not multiplied by the colour"
    (Glazed { color = board; mirror = red })
    ~diffuse:blue ~highlight:None ~mirror:red

let asks () =
  let check name (m : Material.t) diffuses mirrors =
    Alcotest.(check (pair bool bool))
      name (diffuses, mirrors)
      (Lobes.diffuses m, Lobes.mirrors m)
  in
  check "matte" (Matte { color = board }) true false;
  check "black matte" (Matte { color = half_dark }) false false;
  check "matte, lit in one cell" (Matte { color = half_lit }) true false;
  check "black phong that shines"
    (Phong { color = dark; specular = red; shininess = 1. })
    true false;
  check "phong without shine"
    (Phong { color = board; specular = Rgb.black; shininess = 1. })
    true false;
  check "black phong"
    (Phong { color = dark; specular = Rgb.black; shininess = 1. })
    false false;
  check "mirror" (Mirror { color = board }) false true;
  check "black mirror" (Mirror { color = dark }) false false;
  check "glazed" (Glazed { color = board; mirror = red }) true true;
  check "glazed on black" (Glazed { color = dark; mirror = red }) false true;
  check "glazed that does not reflect"
    (Glazed { color = board; mirror = Rgb.black })
    true false

let sound m =
  let l = Lobes.of_material m here in
  let shows =
    not
      (Rgb.is_black l.diffuse
      && Option.fold ~none:true
           ~some:(fun (h : Lobes.highlight) -> Rgb.is_black h.specular)
           l.highlight)
  in
  ((not shows) || Lobes.diffuses m) && (Rgb.is_black l.mirror || Lobes.mirrors m)

let suite =
  ( "lobes",
    [
      Law.example "each material's lobes, colours taken at the point" lobes;
      Law.example "which materials diffuse and which mirror" asks;
      Law.law ~print:Material.show "a lobe that is not black is asked for"
        Drawn.material sound;
    ] )
