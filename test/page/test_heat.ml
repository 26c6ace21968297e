open Candor_colour
open Candor_image
open Candor_cost
open Candor_oracle

let one heat v =
  let plane = Plane.init ~width:1 ~height:1 (fun _ -> v) in
  Picture.pixel (Heat.map heat plane) 0 0

let same name a b = Alcotest.(check bool) name true (Rgb.equal a b)

let doublings () =
  let is name share v = same name (Magma.colour share) (one Heat.errors v) in
  is "no error" 0. 0.;
  is "a quarter" 0. 0.25;
  is "four" 0.5 4.;
  is "64" 1. 64.;
  is "infinite" 1. infinity;
  is "not a number" 0. nan;
  same "the mean" (Magma.colour 0.5) (one Heat.shares 1.)

let seconds () =
  let plane = Plane.init ~width:201 ~height:1 float_of_int in
  let map = Heat.map (Heat.seconds plane) plane in
  same "nothing" (Magma.colour 0.) (Picture.pixel map 0 0);
  same "half" (Magma.colour 0.5) (Picture.pixel map 99 0);
  same "the 99th percentile" (Magma.colour 1.) (Picture.pixel map 198 0);
  let none = Plane.init ~width:1 ~height:1 (fun _ -> nan) in
  same "no number" (Magma.colour 0.) (one (Heat.seconds none) nan)

let suite =
  ( "heat",
    [
      Law.example "errors and samples go by doublings" doublings;
      Law.example "times go evenly to their 99th percentile" seconds;
    ] )
