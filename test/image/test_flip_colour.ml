open Candor_colour
open Candor_image
open Support
open QCheck2

let near name = Alcotest.(check (float 1e-6)) name

let srgb () =
  let check v expected =
    near (string_of_float v) expected (Flip_colour.linear_of_srgb v)
  in
  check 0. 0.;
  check 0.04 (0.04 /. 12.92);
  check 0.5 0.21404114;
  check 1. 1.

let whites () =
  let o = Flip_colour.opponent Rgb.white in
  near "y" 100. o.y;
  near "cx" 0. o.cx;
  near "cz" 0. o.cz;
  near "black" (-16.) (Flip_colour.opponent Rgb.black).y;
  near "bright" 1. (Flip_colour.brightness 100.);
  near "dark" 0. (Flip_colour.brightness (-16.));
  let s = Flip_colour.seen Rgb.white in
  near "l" 100. s.l;
  near "a" 0. s.a;
  near "b" 0. s.b;
  near "black's l" 0. (Flip_colour.seen Rgb.black).l

(* CIELAB of sRGB's blue, as tables have it, times l / 100. *)
let blue () =
  let s = Flip_colour.seen (Rgb.v 0. 0. 1.) in
  let about name = Alcotest.(check (float 0.02)) name in
  about "l" 32.297 s.l;
  about "a" (0.32297 *. 79.188) s.a;
  about "b" (0.32297 *. -107.860) s.b

let distances () =
  let seen l a b = { Flip_colour.l; a; b } in
  near "l alone adds up" 8.
    (Flip_colour.distance (seen 10. 1. 2.) (seen 13. 4. (-2.)))

let part = Gen.float_bound_inclusive 1.
let colour = Gen.map3 Rgb.v part part part

let back c =
  let near a b = Float.abs (a -. b) < 1e-6 in
  let d = Flip_colour.light (Flip_colour.opponent c) in
  near c.r d.r && near c.g d.g && near c.b d.b

let clamped (y, cx, cz) =
  let { Rgb.r; g; b } = Flip_colour.light { y; cx; cz } in
  List.for_all (fun v -> v >= 0. && v <= 1.) [ r; g; b ]

let tests =
  let wide = Gen.float_range (-300.) 300. in
  [
    unit "sRGB's values mean the light that the standard says" srgb;
    unit "white and black are where they should be" whites;
    unit "blue is where tables have it" blue;
    unit "lightness adds to the distance of colours" distances;
    law "YCxCz leads back to the light" colour back;
    law "light is within the display's range"
      (Gen.triple wide wide wide)
      clamped;
  ]

let suite = ("flip_colour", tests)
