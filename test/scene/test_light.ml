open Candor_space
open Candor_colour
open Candor_scene
open Candor_oracle
open Candor_scene_made
open QCheck2

let p = Point.v 1. 2. 3.
let q = Point.v 4. 5. 6.
let bright = Rgb.v 7. 8. 9.
let dim = Rgb.v 7. 8. 1.

module Kind = struct
  type t = Light.kind

  let show = Light.show_kind
  let equal = Light.equal_kind
  let compare = Light.compare_kind
end

let point ?(at = p) ?(intensity = bright) ?(falloff = Light.Square) () =
  Light.Point { at; intensity; falloff }

let directional ?(direction = Vec.v 0. (-1.) 0.) ?(irradiance = bright) () =
  Light.Directional { direction; irradiance }

let spot ?(at = p) ?(toward = q) ?(intensity = bright) ?(inner = 10.)
    ?(outer = 20.) ?(falloff = Light.Square) () =
  Light.Spot { at; toward; intensity; inner; outer; falloff }

let points () =
  Derived.notices
    (module Kind)
    (point ())
    [
      ("at", point ~at:q ());
      ("intensity", point ~intensity:dim ());
      ("falloff", point ~falloff:Constant ());
      ("directional", directional ());
      ("spot", spot ());
    ]

let directionals () =
  Derived.notices
    (module Kind)
    (directional ())
    [
      ("direction", directional ~direction:(Vec.v 0. 1. 0.) ());
      ("length of direction", directional ~direction:(Vec.v 0. (-2.) 0.) ());
      ("irradiance", directional ~irradiance:dim ());
    ]

let spots () =
  Derived.notices
    (module Kind)
    (spot ())
    [
      ("at", spot ~at:q ());
      ("toward", spot ~toward:p ());
      ("intensity", spot ~intensity:dim ());
      ("inner", spot ~inner:5. ());
      ("outer", spot ~outer:25. ());
      ("falloff", spot ~falloff:Constant ());
    ]

let lights () =
  let place = { Place.file = "a.scene"; line = 3; column = 5 } in
  let light = { Light.kind = point (); shadows = true; place } in
  Derived.notices
    (module Light)
    light
    [
      ("kind", { light with kind = spot () });
      ("shadows", { light with shadows = false });
      ("file", { light with place = { place with file = "b.scene" } });
      ("line", { light with place = { place with line = 4 } });
      ("column", { light with place = { place with column = 6 } });
    ]

module Falloff = struct
  type t = Light.falloff

  let show = Light.show_falloff
  let equal = Light.equal_falloff
  let compare = Light.compare_falloff
end

let falloffs () =
  Derived.notices (module Falloff) Square [ ("constant", Light.Constant) ];
  Alcotest.(check (list string))
    "shown"
    [ "Light.Square"; "Light.Constant" ]
    (List.map Light.show_falloff [ Square; Constant ])

let drawn = Derived.often (Gen.map (fun make -> make 7) (Drawn.light Round))

let suite =
  ( "lights",
    Derived.laws (module Light) "lights" drawn
    @ [
        Law.example "each field of a point light counts" points;
        Law.example "each field of a directional light counts" directionals;
        Law.example "each field of a spot light counts" spots;
        Law.example "shadows and place of a light count" lights;
        Law.example "there are two ways to fall off" falloffs;
      ] )
