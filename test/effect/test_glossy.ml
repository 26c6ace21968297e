open Candor_colour
open Candor_optics
open Candor_effect
open Candor_oracle

let scene material =
  Lit.scene
    [
      "(box (min -9 -1 -9) (max 9 0 9) (material " ^ material ^ "))";
      "(sphere (center 0 0 0) (radius 100) (material (emitter (radiance (rgb 3 \
       2 1)))) (both-sides))";
    ]

let metal = "(metal (reflectance 1) (roughness .3))"

let run ?veil ?path material =
  let s = scene material in
  let vertex = Followed.vertex ?path s (3., 2., 1.) (-3., -2., -1.) in
  let term = Glossy.term ?veil (Area_lights.make s) (Lit.tracer s) in
  Followed.v term vertex

(* In a lamp that is all around, one way or the other finds it: together they
   are what the metal sends of it. *)
let one_ray () =
  for i = 0 to 99 do
    let f = run ~path:(Followed.path i) metal in
    Alcotest.(check int) "no recursion" 0 (List.length f.rays);
    Alcotest.(check bool)
      "at most one ray" true
      (Tally.get f.tally Emitter_rays <= 1);
    Alcotest.(check bool) "not more than there is" true (f.value.r <= 3.)
  done

let veiled () =
  let path = Followed.path 5 in
  let plain = run ~path metal in
  let veil _ _ _ = Rgb.v 1. 0.5 0. in
  let less = run ~veil ~path metal in
  Alcotest.(check bool) "something comes" true (plain.value.r > 0.);
  Lit.check_close "what the veil lets through"
    (Rgb.mul (Rgb.v 1. 0.5 0.) plain.value)
    less.value

let none () =
  List.iter
    (fun material ->
      let f = run material in
      Alcotest.check Lit.rgb material Rgb.black f.value;
      Alcotest.(check int) material 0 (Tally.get f.tally Emitter_rays))
    [
      "(matte (color 1))";
      "(mirror)";
      "(metal (reflectance 1) (roughness 0))";
      "(glass (index 1.5))";
    ]

let calls () =
  let count text =
    List.length
      (Glossy.calls
         (Lit.scene
            [ "(sphere (center 0 0 0) (radius 1) (material " ^ text ^ "))" ]))
  in
  List.iter
    (fun (text, expected) -> Alcotest.(check int) text expected (count text))
    [
      (metal, 1);
      ("(metal (reflectance 1) (roughness 0))", 0);
      ("(plastic (color 1) (index 1.5) (roughness .2))", 1);
      ("(plastic (color 1) (index 1.5) (roughness 0))", 1);
      ("(plastic (color 0) (index 1.5) (roughness 0))", 0);
      ("(phong (color 1) (specular 1) (shininess 9))", 0);
    ]

let suite =
  ( "gloss",
    [
      Law.example "one ray looks for lights, and paths end there" one_ray;
      Law.example "a veil takes its part" veiled;
      Law.example "what has no gloss looks for none" none;
      Law.example "rough metal and plastic call for it" calls;
    ] )
