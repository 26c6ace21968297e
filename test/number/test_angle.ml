open Candor_number
open Candor_oracle
open QCheck2

let exact name f rows () =
  List.iter
    (fun (a, expected) ->
      Alcotest.(check (float 0.)) (Printf.sprintf "%s %g" name a) expected (f a))
    rows

let cosines =
  [
    (0., 1.);
    (90., 0.);
    (180., -1.);
    (270., 0.);
    (360., 1.);
    (-90., 0.);
    (-180., -1.);
    (450., 0.);
    (-720., 1.);
    (3.6e17, 1.);
  ]

let sines =
  [
    (0., 0.);
    (90., 1.);
    (180., 0.);
    (270., -1.);
    (360., 0.);
    (-90., -1.);
    (450., 1.);
    (-180., 0.);
  ]

let tangents =
  [
    (0., 0.);
    (45., 1.);
    (-45., -1.);
    (135., -1.);
    (225., 1.);
    (180., 0.);
    (-135., 1.);
  ]

let angle =
  Gen.oneof
    [
      Draw.uniform (-720.) 720.;
      Draw.small 1000;
      Draw.signed (Draw.wide (-10.) 6.);
    ]

let show = Printf.sprintf "%h"

let agrees a =
  let r = Angle.radians (Float.rem a 360.) in
  let close x y = Float.abs (x -. y) <= 0x1p-48 in
  close (Angle.cos a) (cos r) && close (Angle.sin a) (sin r)

let symmetric a =
  Angle.cos (-.a) = Angle.cos a && Angle.sin (-.a) = -.Angle.sin a

let on_circle a =
  let c = Angle.cos a and s = Angle.sin a in
  Float.abs ((c *. c) +. (s *. s) -. 1.) <= 0x1p-51

let turns a =
  (* Adding a quarter is exact for these. *)
  let a = Float.round (a *. 8.) /. 8. in
  Float.abs (Float.rem a 90.) = 45.
  || (Angle.cos (a +. 90.) = -.Angle.sin a && Angle.sin (a +. 90.) = Angle.cos a)

let law = Law.law ~count:20000 ~print:show

let suite =
  ( "angles",
    [
      Law.example "cosines of quarter turns are exact"
        (exact "cos" Angle.cos cosines);
      Law.example "sines of quarter turns are exact"
        (exact "sin" Angle.sin sines);
      Law.example "tangents of eighths are exact"
        (exact "tan" Angle.tan tangents);
      law "cosine and sine agree with those of radians" angle agrees;
      law "cosine is even and sine odd, to the bit" angle symmetric;
      law "cosine and sine lie on the unit circle" angle on_circle;
      law "a quarter turn swaps cosine and sine to the bit, but at eighths"
        angle turns;
    ] )
