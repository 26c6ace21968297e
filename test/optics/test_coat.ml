open Candor_space
open Candor_colour
open Candor_optics
open Candor_oracle
open QCheck2

(* The diffuse reflectance of a boundary from outside: J. Walsh, The Reflection
   Factor of a Polished Glass Surface for Diffused Light, 1926. *)
let walsh n =
  let n2 = n *. n in
  let n4 = n2 *. n2 and more = n2 +. 1. and less = n2 -. 1. in
  0.5
  +. ((n -. 1.) *. ((3. *. n) +. 1.) /. (6. *. ((n +. 1.) ** 2.)))
  +. (n2 *. (less ** 2.) /. (more ** 3.) *. log ((n -. 1.) /. (n +. 1.)))
  -. (2. *. n2 *. n *. (n2 +. (2. *. n) -. 1.) /. (more *. (n4 -. 1.)))
  +. (8. *. n4 *. (n4 +. 1.) /. (more *. ((n4 -. 1.) ** 2.)) *. log n)

let smooth index = Coat.make ~index ~roughness:0.

(* The base of colour 1 is 1 over pi and what enters. *)
let entering coat = 1. /. (Float.pi *. (Coat.base coat Rgb.white).r)

let diffuse () =
  List.iter
    (fun n ->
      let outside = entering (smooth n)
      and inside = n *. n *. entering (smooth (1. /. n)) in
      let name = Printf.sprintf "index %g" n in
      Near.float ~within:1e-5 name (1. -. walsh n) outside;
      Near.float ~within:1e-5 (name ^ ", inverse") (1. -. walsh n) inside)
    [ 1.02; 1.1; 1.33; 1.5; 2.; 3. ]

(* For index 1.5 the boundary turns back 59.6 % of the light inside. *)
let inside () =
  let k = 0.5 in
  let escape = (1. -. walsh 1.5) /. 2.25 in
  Near.float ~within:1e-5 "half grey under glass"
    (escape *. k /. (1. -. (k *. (1. -. escape))))
    (Coat.albedo (smooth 1.5) (Rgb.grey k)).r

let nothing () =
  List.iter
    (fun roughness ->
      let coat = Coat.make ~index:1. ~roughness in
      let color = Rgb.v 0.1 0.5 1. in
      Near.rgb "matte" (Rgb.scale (1. /. Float.pi) color) (Coat.base coat color);
      Near.float "all passes" 1. (Coat.transmittance coat 0.3);
      Near.float "none is reflected" 0. (Coat.reflectance coat 0.3))
    [ 0.; 0.2; 1. ]

(* What a coat reflects in all, by adding up its BRDF. *)
let reflected ~index ~roughness c =
  let normal = Dir.z and sine = sqrt ((1. -. c) *. (1. +. c)) in
  let view = Dir.of_vec_or Dir.x (Vec.v sine 0. c) in
  let into = { Refraction.from = 1.; into = index } in
  let value toward =
    let facing = sqrt ((1. +. Dir.dot view toward) /. 2.) in
    Refraction.reflectance into facing
    *. Microfacet.reflection ~alpha:roughness ~normal ~view ~toward
    *. Dir.dot normal toward
  in
  Directions.integral ~fine:8
    (Directions.reflected ~normal ~view ~width:roughness)
    value

let coats =
  List.concat_map
    (fun index -> List.map (fun r -> (index, r)) [ 0x1p-7; 0.1; 0.4; 1. ])
    [ 0.7; 0.95; 1.05; 1.5; 4. ]

(* By the table's own measure: no more than the rest, and little less. *)
let tabulated () =
  List.iter
    (fun (index, roughness) ->
      let coat = Coat.make ~index ~roughness in
      List.iter
        (fun c ->
          let passing = Coat.transmittance coat c in
          let lost = 1. -. passing -. reflected ~index ~roughness c in
          if not (lost > -1e-3 && lost < if index < 1. then 0.4 else 0.03) then
            Alcotest.failf "index %g, roughness %g, cosine %g: %g is lost" index
              roughness c lost)
        [ 0.003; 0.04; 0.11; 0.3; 0.52; 0.6; 0.77; 0.9; 1. ])
    coats

let index =
  Gen.oneof
    [
      Draw.uniform 1. 3.;
      Draw.uniform 0.1 1.;
      Draw.nudged (Draw.pick [ 1. ]);
      Draw.power (-100) 100;
    ]

let roughness =
  Gen.oneof [ Draw.pick [ 0.; 0.; 0.; 1.; 0x1p-60 ]; Draw.uniform 0. 1. ]

let colour = Gen.oneof [ Draw.uniform 0. 1.; Draw.pick [ 0.; 1. ] ]

let case =
  Gen.(
    pair
      (Draw.pool 30
         (pair index roughness
         |> map (fun (index, roughness) ->
             (index, roughness, Coat.make ~index ~roughness))))
      (triple colour colour (Draw.uniform (-0.1) 1.1)))

let show ((index, roughness, _), (k, k', c)) =
  Printf.sprintf "index %h, roughness %h, colours %h and %h, cosine %h" index
    roughness k k' c

let within x = 0. <= x && x <= 1.

let total ((_, _, coat), (k, k', c)) =
  let low = Float.min k k' and high = Float.max k k' in
  let albedo = Coat.albedo coat (Rgb.v low high 1.) in
  let base = Coat.base coat (Rgb.v low high 1.) in
  within (Coat.transmittance coat c)
  && within (Coat.reflectance coat c)
  && within albedo.r && albedo.r <= albedo.g && albedo.g <= albedo.b
  && within albedo.b && Rgb.is_finite base && base.r >= 0.
  && (albedo.b = 1. || (Rgb.is_black albedo && Rgb.is_black base))

let suite =
  ( "coat",
    [
      Law.example "diffuse light enters as in closed form" diffuse;
      Law.example "light turned back inside meets the base again" inside;
      Law.example "a coat of index 1 is not there" nothing;
      Law.example "a rough coat passes what it does not reflect, and no more"
        tabulated;
      Law.law ~print:show
        "what passes and what comes back is in [0;1], more of brighter colours"
        case total;
    ] )
