open Candor_colour
open Candor_effect
open Candor_oracle

let glow = Rgb.v 3. 2. 1.

let at_z extra =
  Lit.scene
    [
      Printf.sprintf
        "(triangle (-9 -9 0) (9 -9 0) (0 9 0) (material (emitter (radiance \
         (rgb 3 2 1)))) %s)"
        extra;
    ]

let seen ?(extra = "") z =
  Emission.radiance (Lit.hit (at_z extra) (0., 0., z) (0., 0., -.z))

let sides () =
  Alcotest.check Lit.rgb "from outside" glow (seen 5.);
  Alcotest.check Lit.rgb "from inside" Rgb.black (seen (-5.));
  Alcotest.check Lit.rgb "both sides, outside" glow
    (seen ~extra:"(both-sides)" 5.);
  Alcotest.check Lit.rgb "both sides, inside" glow
    (seen ~extra:"(both-sides)" (-5.))

let term () =
  let vertex = Followed.vertex (at_z "") (0., 0., 5.) (0., 0., -2.) in
  let value term = (Followed.v term vertex).value in
  Alcotest.check Lit.rgb "in full" glow (value (Emission.term ()));
  Alcotest.check Lit.rgb "by its weight" (Rgb.v 1.5 1. 0.5)
    (value (Emission.term ~weigh:(fun _ _ -> 0.5) ()));
  let dark = Followed.vertex (at_z "") (0., 0., -5.) (0., 0., 2.) in
  let never _ _ = Alcotest.fail "nothing to weigh" in
  Alcotest.check Lit.rgb "what does not shine is not weighed" Rgb.black
    (Followed.v (Emission.term ~weigh:never ()) dark).value

let calls () =
  let count forms = List.length (Emission.calls (Lit.scene forms)) in
  Alcotest.(check int) "none" 0 (count [ "(sphere (center 0 0 0) (radius 1))" ]);
  Alcotest.(check int)
    "an emitter and a material that emits" 2
    (count
       [
         "(sphere (center 0 0 0) (radius 1) (material (emitter (radiance 1))))";
         "(sphere (center 3 0 0) (radius 1) (material (matte (color .5) \
          (emission 1))))";
         "(sphere (center 6 0 0) (radius 1) (material (matte (color .5) \
          (emission 0))))";
       ])

let suite =
  ( "emission",
    [
      Law.example "surfaces shine from their outer side, or from both" sides;
      Law.example "the term is the radiance, weighed" term;
      Law.example "what emits calls for it" calls;
    ] )
