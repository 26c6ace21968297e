open Candor_space
open Candor_colour
open Candor_optics
open Candor_oracle
open QCheck2

let metal = Gloss.metal ~reflectance:(Rgb.v 0.9 0.6 0.2)

let plastic ?(color = Rgb.v 0.9 0.5 0.1) index roughness =
  Gloss.plastic (Coat.make ~index ~roughness) ~color

let white_metal roughness = Gloss.metal ~reflectance:Rgb.white ~roughness

(* {1 A view of a surface} *)

type meeting = { normal : Dir.t; view : Dir.t }

let meeting normal c =
  let f = Frame.of_dir normal and s = sqrt ((1. -. c) *. (1. +. c)) in
  let turn k (d : Dir.t) = Vec.scale k (d :> Vec.t) in
  let aside = Vec.add (turn (0.6 *. s) f.u) (turn (-0.8 *. s) f.v) in
  { normal; view = Dir.of_vec_or normal (Vec.add (turn c f.w) aside) }

let across m ~width = Directions.reflected ~normal:m.normal ~view:m.view ~width
let slant = Dir.of_vec_or Dir.z (Vec.v (-0.4) 0.2 0.7)

(* What comes back in all of white light: the integral over [toward]. *)
let albedo ?(fine = 12) t ~width c =
  let m = meeting slant c in
  Directions.integral ~fine (across m ~width) (fun toward ->
      (Gloss.value t ~normal:m.normal ~view:m.view ~toward).r)

(* {1 Sampling} *)

let draw t m i =
  Gloss.sample t ~normal:m.normal ~view:m.view ~choice:(Directions.uniform i 0)
    ~u:(Directions.uniform i 1) ~v:(Directions.uniform i 2)

let cosines = [ 1.; 0.6; 0.1; 0x1p-10 ]

let rough =
  [
    ("metal 2^-20", metal ~roughness:0x1p-20, 0x1p-20);
    ("metal .02", metal ~roughness:0.02, 0.02);
    ("metal .3", metal ~roughness:0.3, 0.3);
    ("metal 1", metal ~roughness:1., 1.);
    ("plastic .05", plastic 1.5 0.05, 0.1);
    ("plastic .4", plastic 1.5 0.4, 0.4);
    ("plastic 1, index .8", plastic 0.8 1., 1.);
  ]

let smooth = [ ("smooth plastic", plastic 1.5 0., 1.) ]

let each materials f =
  List.iter
    (fun (name, t, width) ->
      List.iter
        (fun c -> f (Printf.sprintf "%s, cosine %g" name c) t width c)
        cosines)
    materials

let densities () =
  each (rough @ smooth) (fun name t width c ->
      let m = meeting slant c in
      let density toward =
        Gloss.density t ~normal:m.normal ~view:m.view ~toward
      in
      Directions.follows name (across m ~width) ~density (fun i ->
          Option.map (fun (s : Gloss.sample) -> s.toward) (draw t m i)))

(* The mean weight of the samples is the integral of the values. *)
let estimates () =
  let count = 12_000 in
  each (rough @ smooth) (fun name t width c ->
      let m = meeting slant c in
      let weight i =
        Option.fold ~none:0.
          ~some:(fun (s : Gloss.sample) -> s.weight.r)
          (draw t m i)
      in
      let n = float_of_int count in
      let sum = Directions.sum count weight
      and squares = Directions.sum count (fun i -> weight i ** 2.) in
      let mean = sum /. n in
      let deviation =
        sqrt (Float.max 0. ((squares /. n) -. (mean *. mean)) /. n)
      in
      let truth = albedo t ~width c in
      if Float.abs (mean -. truth) > (5. *. deviation) +. (0x1p-8 *. truth) then
        Alcotest.failf "%s: the mean weight is %g, the integral %g" name mean
          truth)

(* {1 Laws} *)

let number = Draw.uniform 0. 0x1.fffffffffffffp-1

let roughness =
  Gen.oneof
    [
      Draw.uniform 0. 1.;
      Draw.wide (-6.) 0.;
      Draw.pick [ 0.; 1.; 0x1p-20; 0x1p-60 ];
    ]

let index =
  Gen.oneof
    [
      Draw.uniform 1. 3.;
      Draw.uniform 0.3 1.;
      Draw.pick [ 1.; 0x1p-100; 0x1p100 ];
    ]

let colour =
  let part = Gen.oneof [ Draw.uniform 0. 1.; Draw.pick [ 0.; 1. ] ] in
  Gen.map3 Rgb.v part part part

let coat =
  Draw.pool 30
    (Gen.map2
       (fun index roughness -> Coat.make ~index ~roughness)
       index roughness)

let material =
  Gen.oneof
    [
      Gen.map2
        (fun reflectance roughness -> Gloss.metal ~reflectance ~roughness)
        colour roughness;
      Gen.map2 (fun coat color -> Gloss.plastic coat ~color) coat colour;
    ]

let cosine = Gen.oneof [ Draw.uniform 0. 1.; Draw.wide (-20.) 0. ]

let placed =
  let open Gen in
  let* normal = Draw.unit and* c = cosine and* c' = cosine in
  let* toward = Draw.across normal in
  let normal = Dir.of_vec_or Dir.z normal in
  let s = sqrt ((1. -. c') *. (1. +. c')) in
  let toward = Vec.add (Vec.scale c' (normal :> Vec.t)) (Vec.scale s toward) in
  let* toward = oneof [ return toward; Draw.unit ] in
  return (meeting normal c, Dir.of_vec_or Dir.z toward)

let case = Gen.(pair (pair material placed) (triple number number number))

let show ((_, (m, (toward : Dir.t))), (choice, u, v)) =
  Printf.sprintf "normal %s, view %s, toward %s, numbers %h %h %h"
    (Draw.show_vec (m.normal :> Vec.t))
    (Draw.show_vec (m.view :> Vec.t))
    (Draw.show_vec (toward :> Vec.t))
    choice u v

let law name holds = Law.law ~count:5000 ~print:show name case holds

let close within (a : Rgb.t) (b : Rgb.t) =
  let near x y = Float.abs (x -. y) <= within *. Float.abs y in
  near a.r b.r && near a.g b.g && near a.b b.b

let weighed ((t, (m, _)), (choice, u, v)) =
  let normal = m.normal and view = m.view in
  match Gloss.sample t ~normal ~view ~choice ~u ~v with
  | None -> true
  | Some { toward; weight; density } ->
      Rgb.is_finite weight && Float.is_finite density && density > 0.
      && Dir.dot normal toward > 0.
      && density = Gloss.density t ~normal ~view ~toward
      && close 0x1p-50 (Rgb.scale density weight)
           (Gloss.value t ~normal ~view ~toward)

let reciprocal ((t, (m, toward)), _) =
  let c = Dir.dot m.normal m.view and c' = Dir.dot m.normal toward in
  let value = Gloss.value t ~normal:m.normal in
  (not (c > 0. && c' > 0.))
  || close 0x1p-45
       (Rgb.scale c (value ~view:m.view ~toward))
       (Rgb.scale c' (value ~view:toward ~toward:m.view))

let sided ((t, (m, toward)), _) =
  let normal = m.normal and view = m.view in
  let value = Gloss.value t ~normal ~view ~toward in
  let density = Gloss.density t ~normal ~view ~toward in
  let below = not (Dir.dot normal toward > 0. && Dir.dot normal view > 0.) in
  Rgb.is_finite value && Float.is_finite density && value.r >= 0.
  && value.g >= 0. && value.b >= 0. && density >= 0.
  && ((not below) || (Rgb.is_black value && density = 0.))

let smooth_law ((t, (m, toward)), (choice, u, v)) =
  let normal = m.normal and view = m.view in
  (not (Gloss.is_smooth t))
  ||
  let value = Gloss.value t ~normal ~view ~toward in
  let density = Gloss.density t ~normal ~view ~toward in
  let cosine = Float.max 0. (Dir.dot normal toward) in
  let even = Float.abs ((density *. Float.pi) -. cosine) <= 0x1p-50 in
  let sample = Gloss.sample t ~normal ~view ~choice ~u ~v in
  (density = 0. && Rgb.is_black value) || (even && Option.is_some sample)

(* {1 Energy} *)

let levels = [ 0x1p-20; 0.1; 0.25; 0.5; 0.75; 1. ]

(* The part lost of white light, at cosines 1, .6 and .1, by roughness: the
   table of the interface. *)
let table =
  [
    (0.1, [ 0.012; 0.023; 0.117 ]);
    (0.25, [ 0.084; 0.128; 0.108 ]);
    (0.5, [ 0.312; 0.312; 0.140 ]);
    (0.75, [ 0.536; 0.465; 0.189 ]);
    (1., [ 0.693; 0.588; 0.240 ]);
  ]

let losses () =
  let check (roughness, parts) =
    let t = white_metal roughness in
    let lost c part =
      Near.float ~within:0.001
        (Printf.sprintf "roughness %g, cosine %g" roughness c)
        part
        (1. -. albedo t ~width:roughness c)
    in
    List.iter2 lost [ 1.; 0.6; 0.1 ] parts
  in
  List.iter check table

(* With alpha 1 the mirrors face everywhere alike, and the BRDF is
   1 / 2 pi (c + c'). *)
let roughest () =
  List.iter
    (fun c ->
      Near.float ~within:0x1p-9
        (Printf.sprintf "cosine %g" c)
        (1. -. (c *. log ((1. +. c) /. c)))
        (albedo (white_metal 1.) ~width:1. c))
    [ 1.; 0.7; 0.3; 0.05; 0x1p-10 ]

let white_metals () =
  List.iter
    (fun roughness ->
      List.iter
        (fun c ->
          let t = white_metal roughness in
          let back = albedo ~fine:24 t ~width:roughness c in
          if not (back <= 1.002 && back > 0.3) then
            Alcotest.failf "roughness %g, cosine %g: %g comes back" roughness c
              back)
        [ 1.; 0.6; 0.25; 0.1; 0x1p-6 ])
    levels

let white_plastics () =
  List.iter
    (fun (index, roughness) ->
      let t = plastic ~color:Rgb.white index roughness in
      let width = if roughness = 0. then 1. else sqrt roughness in
      List.iter
        (fun c ->
          let back = albedo ~fine:10 t ~width c in
          let back =
            if Gloss.is_smooth t then back +. (Gloss.specular t ~cos:c).r
            else back
          in
          let lost, more = if index < 1. then (0.4, 4e-3) else (0.03, 1e-3) in
          if not (back <= 1. +. more && back > 1. -. lost) then
            Alcotest.failf "index %g, roughness %g, cosine %g: %g comes back"
              index roughness c back)
        [ 1.; 0.86; 0.5; 0.3; 0.15; 0.05; 0x1p-10 ])
    (List.concat_map
       (fun index -> List.map (fun r -> (index, r)) [ 0.; 0.02; 0.1; 0.3; 1. ])
       [ 0.6; 0.9; 1.; 1.02; 1.5; 2.4; 8. ])

let in_all () =
  each rough (fun name t width c ->
      let m = meeting slant c in
      let density toward =
        Gloss.density t ~normal:m.normal ~view:m.view ~toward
      in
      let all = Directions.integral ~fine:12 (across m ~width) density in
      if not (all <= 1.004) then Alcotest.failf "%s: %g in all" name all)

let mirrors () =
  let gold = Rgb.v 0.9 0.6 0.2 in
  let specular cos = Gloss.specular (metal ~roughness:0.) ~cos in
  Near.rgb "straight on" gold (specular 1.);
  Near.rgb "grazing" Rgb.white (specular 0.);
  Near.rgb "at 60 degrees"
    (Rgb.add gold (Rgb.scale 0x1p-5 (Rgb.v 0.1 0.4 0.8)))
    (specular 0.5);
  Near.rgb "glass, straight on" (Rgb.grey 0.04)
    (Gloss.specular (plastic 1.5 0.2) ~cos:1.);
  let smooth t = Alcotest.(check bool) "smooth" true (Gloss.is_smooth t) in
  smooth (metal ~roughness:0.);
  smooth (plastic 1.5 0.);
  Alcotest.(check bool)
    "rough" false
    (Gloss.is_smooth (metal ~roughness:0x1p-1000))

let suite =
  ( "gloss",
    [
      Law.example "directions are sampled as densely as said" densities;
      Law.example "samples weigh in all what the values add up to" estimates;
      law "a sample weighs its value over its density" weighed;
      law "light goes back as it came" reciprocal;
      law "values are finite, never negative, and nothing is below the surface"
        sided;
      law "of a smooth surface only the base has values and samples" smooth_law;
      Law.example "rough metal loses what its interface says" losses;
      Law.example "the roughest metal reflects as in closed form" roughest;
      Law.example "no metal returns more light than it gets" white_metals;
      Law.example "no plastic returns more light than it gets, or much less"
        white_plastics;
      Law.example "no density adds up to more than 1" in_all;
      Law.example "one mirror reflects as Schlick's or Fresnel's formula says"
        mirrors;
    ] )
