open Candor_space
open Candor_colour
open Candor_effect
open Candor_oracle

let adds () =
  let term = Ambient.term (Rgb.v 0.5 0.25 0.) in
  let at material =
    let s =
      Lit.scene
        [ "(sphere (center 0 0 0) (radius 1) (material " ^ material ^ "))" ]
    in
    let vertex =
      Lit.vertex (Lit.hit s (0., 0., 5.) (0., 0., -1.)) (Vec.v 0. 0. 1.)
    in
    term Lit.no_recursion (Tally.make ()) vertex
  in
  let check name expected m = Alcotest.check Lit.rgb name expected (at m) in
  check "matte" (Rgb.v 0.25 0.0625 0.) "(matte (color (rgb .5 .25 1)))";
  check "phong, without its highlight" (Rgb.v 0.25 0.125 0.)
    "(phong (color .5) (specular 1) (shininess 1))";
  check "glazed, without its mirror" (Rgb.v 0.25 0.125 0.)
    "(glazed (color .5) (mirror 1))";
  check "mirror" Rgb.black "(mirror)"

let suite =
  ( "ambient",
    [ Law.example "adds albedo times L_a where a matte part is seen" adds ] )
