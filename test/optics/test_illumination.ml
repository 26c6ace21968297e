open Candor_space
open Candor_colour
open Candor_scene
open Candor_optics
open Candor_oracle
open QCheck2

let light kind = { Light.kind; shadows = true; place = Place.unknown }
let intensity = Rgb.v 300. 20. 1.

let point ?(falloff = Light.Square) at =
  light (Point { at; intensity; falloff })

let spot ?(falloff = Light.Square) ?(at = Point.origin)
    ?(toward = Point.v 0. 0. (-3.)) inner outer =
  light (Spot { at; toward; intensity; inner; outer; falloff })

let at l p = (Illumination.compile l p : Illumination.t)
let points = Draw.point (Draw.uniform (-9.) 9.)
let pairs = Gen.pair points points
let show (p, q) = Draw.show_point p ^ " " ^ Draw.show_point q

let same (a : Rgb.t) (b : Rgb.t) =
  List.for_all2
    (fun x y -> Near.close ~within:1e-14 x y)
    [ a.r; a.g; a.b ] [ b.r; b.g; b.b ]

let inverse_square (l, p) =
  let { Illumination.toward; irradiance } = at (point l) p in
  let r2 =
    ((l.x -. p.x) ** 2.) +. ((l.y -. p.y) ** 2.) +. ((l.z -. p.z) ** 2.)
  in
  Vec.equal toward (Point.sub l p)
  && same irradiance (Rgb.scale (1. /. r2) intensity)

let no_falloff (l, p) =
  let { Illumination.toward; irradiance } = at (point ~falloff:Constant l) p in
  Vec.equal toward (Point.sub l p) && Rgb.equal irradiance intensity

let directional =
  Law.law ~print:show
    "a directional light is the same everywhere, V as long as it likes" pairs
    (fun (p, v) ->
      let direction = Point.sub v Point.origin in
      let l = light (Directional { direction; irradiance = intensity }) in
      let { Illumination.toward; irradiance } = at l p in
      Vec.equal toward (Vec.neg direction) && Rgb.equal irradiance intensity)

(* A point at an angle from the axis of a spot at the origin shining along −z. *)
let under degrees distance =
  let a = degrees *. Float.pi /. 180. in
  Point.v (distance *. sin a) 0. (-.distance *. cos a)

let red ?falloff ?(distance = 1.) inner outer degrees =
  (at (spot ?falloff inner outer) (under degrees distance)).irradiance.r /. 300.

(* The smooth step of the cosine. *)
let factor inner outer degrees =
  let cos d = Float.cos (d *. Float.pi /. 180.) in
  if degrees <= inner then 1.
  else if degrees >= outer then 0.
  else
    let s = (cos degrees -. cos outer) /. (cos inner -. cos outer) in
    s *. s *. (3. -. (2. *. s))

let cone =
  let gen =
    Gen.triple (Draw.uniform 0. 90.) (Draw.uniform 0. 90.)
      (Draw.uniform 0. 180.)
  in
  Law.law
    ~print:(fun (a, b, c) -> Printf.sprintf "%g %g, seen at %g" a b c)
    "a spot follows the smooth step between its cones" gen
    (fun (a, b, angle) ->
      let inner = Float.min a b and outer = Float.max a b in
      (* Between cones this close the step is too steep to compare. *)
      outer -. inner < 1.
      || Near.close ~within:1e-10 (red inner outer angle)
           (factor inner outer angle))

let ends () =
  let check name expected actual = Near.float name expected actual in
  check "on the axis" 1. (red 10. 40. 0.);
  check "just within the inner cone" 1. (red 10. 40. 9.999999);
  check "just within the outer cone" 0. (red ~distance:1. 10. 40. 39.9999999);
  check "just outside" 0. (red 10. 40. 40.0000001);
  check "behind" 0. (red 10. 40. 180.);
  check "the middle of the step" 0.5
    (red 10. 40.
       (acos ((Float.cos (Float.pi /. 18.) +. Float.cos (Float.pi /. 4.5)) /. 2.)
       *. 180. /. Float.pi));
  check "a hard edge, inside" 1. (red 30. 30. 29.9999999);
  check "a hard edge, outside" 0. (red 30. 30. 30.0000001);
  check "a half-space" 1. (red 90. 90. 89.9999999);
  check "nothing behind it" 0. (red 90. 90. 90.0000001);
  check "a needle, on its axis" 1. (red 0. 0. 0.);
  check "a needle, beside it" 0. (red 0. 0. 0.001);
  check "falls off with the square" 0.0625 (red ~distance:4. 10. 40. 0.);
  check "without falloff" 1. (red ~falloff:Constant ~distance:4. 10. 40. 0.)

let smooth () =
  (* No jump, and the slope is zero at both ends: next to them the step differs
     from 0 and 1 by the square of the distance. *)
  Near.float ~within:1e-7 "next to the inner cone" 1. (red 20. 40. 20.001);
  Near.float ~within:1e-7 "next to the outer cone" 0. (red 20. 40. 39.999);
  let at a = red ~falloff:Constant 20. 40. a in
  let rec falls a = a > 45. || (at a >= at (a +. 0.25) && falls (a +. 0.25)) in
  Alcotest.(check bool) "falls from axis to edge" true (falls 0.)

let sources () =
  let is name expected l =
    Alcotest.(check bool) name true (Illumination.source l = expected)
  in
  is "a point light is where it is"
    (At (Point.v 1. 2. 3.))
    (point (Point.v 1. 2. 3.));
  is "a spot too" (At Point.origin) (spot 1. 2.);
  is "a directional light is against its direction"
    (Along (Vec.v (-0.) 1. (-0.)))
    (light
       (Directional { direction = Vec.v 0. (-1.) 0.; irradiance = intensity }))

let scaled (l, p) =
  List.for_all
    (fun k ->
      let scale (p : Point.t) = Point.v (k *. p.x) (k *. p.y) (k *. p.z) in
      let brighter = Rgb.scale (k *. k) intensity in
      let small = at (point l) p
      and large =
        at
          (light
             (Point { at = scale l; intensity = brighter; falloff = Square }))
          (scale p)
      in
      Rgb.equal small.irradiance large.irradiance
      && Vec.equal (Vec.scale k small.toward) large.toward)
    [ 0x1p20; 0x1p-20 ]

let law name f = Law.law ~print:show name pairs f

let suite =
  ( "illumination",
    [
      law "a point light gives intensity/r^2" inverse_square;
      law "without falloff it gives intensity at any distance" no_falloff;
      directional;
      cone;
      Law.example "the ends of a spot's cones" ends;
      Law.example "a spot fades smoothly" smooth;
      Law.example "shadow rays go to the light" sources;
      law
        "scaling by 2^k with 4^k the intensity leaves the irradiance, to the \
         bit"
        scaled;
    ] )
