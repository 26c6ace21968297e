open Candor_space
open Candor_colour
open Candor_effect
open Candor_oracle

let material text =
  let s =
    Lit.scene [ "(sphere (center 0 0 0) (radius 1) (material " ^ text ^ "))" ]
  in
  (Lit.hit s (0., 0., 5.) (0., 0., -1.)).material.material

let tinted = material "(glass (index 1.5) (absorption (rgb 0 .5 2)))"
let clear = material "(glass (index 1.5))"
let cloudy = material "(translucent (index 1.5) (scattering 1) (absorption .5))"

(* A ray of speed 4 that meets the box at z = 0 from z = 3. *)
let floor = Lit.scene [ "(box (min -9 -9 -1) (max 9 9 0))" ]
let ray = Lit.ray (0., 0., 3.) (0., 0., -4.)
let hit = Lit.hit floor (0., 0., 3.) (0., 0., -4.)

(* What arrives, and with what throughput. *)
let arrives inside hit =
  let carried = ref Rgb.black in
  let arrive (path : Path.t) _ _ =
    carried := path.throughput;
    Rgb.white
  in
  let path = Followed.path ~inside 0 in
  let found =
    Absorption.segment Lit.no_recursion (Tally.make ()) path ray hit arrive
  in
  Lit.check_close "throughput" found !carried;
  found

let after length = Rgb.v 1. (exp (-0.5 *. length)) (exp (-2. *. length))

let segment () =
  let check name expected inside hit =
    Lit.check_close name expected (arrives inside hit)
  in
  check "in empty space" Rgb.white [] (Some hit);
  check "in tinted glass" (after 3.) [ tinted ] (Some hit);
  check "in clear glass" Rgb.white [ clear ] (Some hit);
  check "the body entered last counts" Rgb.white [ clear; tinted ] (Some hit);
  check "whatever is around" (after 3.) [ tinted; clear ] (Some hit);
  check "what is cloudy is for another effect" Rgb.white [ cloudy ] (Some hit);
  check "for ever" (Rgb.v 1. 0. 0.) [ tinted ] None

let veil () =
  let check name expected inside source =
    let path = Followed.path ~inside 0 in
    Lit.check_close name expected
      (Absorption.veil path (Point.v 1. 0. 0.) source)
  in
  let light = Candor_optics.Illumination.At (Point.v 1. 2. 0.) in
  check "in empty space" Rgb.white [] light;
  check "in tinted glass" (after 2.) [ tinted ] light;
  check "in clear glass" Rgb.white [ clear ] light;
  check "in a cloud, what is scattered is lost, too"
    (Rgb.grey (exp (-3.)))
    [ cloudy ] light;
  check "from far away" (Rgb.v 1. 0. 0.) [ tinted ] (Along (Vec.v 0. 1. 0.))

let calls () =
  let count text =
    List.length
      (Absorption.calls
         (Lit.scene
            [ "(sphere (center 0 0 0) (radius 1) (material " ^ text ^ "))" ]))
  in
  List.iter
    (fun (text, expected) -> Alcotest.(check int) text expected (count text))
    [
      ("(glass (index 1.5))", 0);
      ("(glass (index 1.5) (absorption 0))", 0);
      ("(glass (index 1.5) (absorption (rgb 0 0 .1)))", 1);
      ("(translucent (index 1.5) (scattering 1) (absorption 1))", 0);
      ("(matte (color 1))", 0);
    ]

let suite =
  ( "absorption",
    [
      Law.example "exp(-absorption length) goes through, of the innermost body"
        segment;
      Law.example "and of the way to a light" veil;
      Law.example "glass that absorbs calls for it" calls;
    ] )
