open Candor_space
open Candor_colour
open Candor_scene
open Text

let read light =
  match (ok_forms (Printf.sprintf "(light %s)" light)).lights with
  | [ l ] -> l
  | lights -> Alcotest.failf "%d lights" (List.length lights)

let check s ?(shadows = true) (kind : Light.kind) =
  let l = read s in
  Alcotest.(check bool) s true (Light.equal_kind kind l.kind);
  Alcotest.(check bool) "shadows" shadows l.shadows

let at = Point.v 1. 2. 3.
let intensity = Rgb.v 4. 5. 6.

let kinds () =
  check "(point (at 1 2 3) (intensity (rgb 4 5 6)))"
    (Point { at; intensity; falloff = Square });
  check "(directional (direction 0 -2 0) (irradiance 3))"
    (Directional { direction = Vec.v 0. (-2.) 0.; irradiance = Rgb.grey 3. });
  check
    "(spot (at 1 2 3) (toward 0 0 0) (intensity (rgb 4 5 6)) (inner 10) (outer \
     10))"
    (Spot
       {
         at;
         toward = Point.origin;
         intensity;
         inner = 10.;
         outer = 10.;
         falloff = Square;
       })

let options () =
  check "(point (at 1 2 3) (intensity (rgb 4 5 6)) (falloff none) (shadows no))"
    ~shadows:false
    (Point { at; intensity; falloff = Constant });
  check "(directional (direction 0 -1 0) (irradiance 0) (shadows no))"
    ~shadows:false
    (Directional { direction = Vec.v 0. (-1.) 0.; irradiance = Rgb.black })

let place () =
  Alcotest.(check string)
    "place" "test.scene:1:70"
    (Place.to_string (read "(point (at 0 0 0) (intensity 1))").place)

let suite =
  ( "light decoder",
    [
      case "each kind of light falls off with the square and casts shadows"
        kinds;
      case "falloff and shadows may be turned off" options;
      case "a light knows its place" place;
    ] )
