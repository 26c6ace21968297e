open Candor_colour
open Candor_image
open Support

let check name v expected =
  let { Rgb.r; g; b } = Magma.colour v in
  Alcotest.(check (list int)) name expected (List.map Display.level [ r; g; b ])

(* As in the authors' table, times 255. *)
let published () =
  check "0" 0. [ 0; 0; 4 ];
  check "1" 1. [ 252; 253; 191 ];
  check "step 64" (64. /. 255.) [ 81; 18; 124 ];
  check "step 128" (128. /. 255.) [ 183; 55; 121 ];
  check "step 200" (200. /. 255.) [ 253; 152; 105 ]

let between () =
  check "half a step goes up" (0.5 /. 255.) [ 1; 0; 5 ];
  check "less goes down" (0.49 /. 255.) [ 0; 0; 4 ];
  check "below" (-1.) [ 0; 0; 4 ];
  check "nan" nan [ 0; 0; 4 ];
  check "above" infinity [ 252; 253; 191 ]

let brightness v =
  let { Rgb.r; g; b } = Magma.colour v in
  (0.2126 *. r) +. (0.7152 *. g) +. (0.0722 *. b)

let lighter () =
  for i = 1 to 255 do
    let step n = brightness (float_of_int n /. 255.) in
    if step i <= step (i - 1) then Alcotest.failf "step %d is darker" i
  done

let suite =
  ( "magma",
    [
      unit "colours are those of the published table" published;
      unit "values between steps, and beyond the ends" between;
      unit "more is lighter" lighter;
    ] )
