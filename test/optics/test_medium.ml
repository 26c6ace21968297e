open Candor_colour
open Candor_scene
open Candor_optics
open Candor_oracle

let medium extinction scattering =
  { Medium.extinction; scattering; anisotropy = 0. }

let rates = QCheck2.Gen.oneof [ QCheck2.Gen.pure 0.; Draw.uniform 0.01 3. ]
let rgb = QCheck2.Gen.map3 Rgb.v

type case = {
  extinction : Rgb.t;
  albedo : Rgb.t;
  carried : Rgb.t;
  limit : float;
}

let cases =
  QCheck2.Gen.map4
    (fun extinction albedo carried limit ->
      { extinction; albedo; carried; limit })
    (rgb rates rates rates)
    (rgb (Draw.uniform 0. 1.) (Draw.uniform 0. 1.) (Draw.uniform 0. 1.))
    (rgb (Draw.uniform 0.1 1.) (Draw.uniform 0.1 1.) (Draw.uniform 0.1 1.))
    (QCheck2.Gen.oneof [ QCheck2.Gen.pure infinity; Draw.uniform 0.1 4. ])

let print { extinction; albedo; carried; limit } =
  Printf.sprintf "extinction %s, albedo %s, carried %s, up to %h"
    (Rgb.show extinction) (Rgb.show albedo) (Rgb.show carried) limit

let of_case c = medium c.extinction (Rgb.mul c.albedo c.extinction)
let numbers = 4000

(* The mean of [f] over numbers that share out [0;1[ evenly. *)
let mean f =
  let at i = f ((float_of_int i +. 0.5) /. float_of_int numbers) in
  List.init numbers at
  |> List.fold_left Rgb.add Rgb.black
  |> Rgb.scale (1. /. float_of_int numbers)

let through rate s = if rate = 0. then 1. else exp (-.rate *. s)
let each f { Rgb.r; g; b } limit = Rgb.v (f r limit) (f g limit) (f b limit)

let near (a : Rgb.t) (b : Rgb.t) =
  let near x y = Near.close ~within:5e-3 x y in
  (near a.r b.r && near a.g b.g && near a.b b.b)
  || Law.fail "expected %s, got %s" (Rgb.show b) (Rgb.show a)

let law name f = Law.law ~count:60 ~print name cases f

let transmittance =
  law "what goes straight through is an exponential" (fun c ->
      Rgb.equal
        (Medium.transmittance (of_case c) c.limit)
        (each through c.extinction c.limit))

let lost rate limit = 1. -. through rate limit

let passes =
  law "in the mean that passes" (fun c ->
      let event u =
        Medium.sample (of_case c) ~carried:c.carried ~limit:c.limit u
      in
      near
        (mean (fun u ->
             match event u with
             | Passed { weight } -> weight
             | Scattered _ -> Rgb.black))
        (each through c.extinction c.limit))

let scatters =
  law "and the albedo of the rest is scattered" (fun c ->
      let event u =
        Medium.sample (of_case c) ~carried:c.carried ~limit:c.limit u
      in
      near
        (mean (fun u ->
             match event u with
             | Scattered { weight; _ } -> weight
             | Passed _ -> Rgb.black))
        (Rgb.mul c.albedo (each lost c.extinction c.limit)))

(* The mean of 1/(1 + s), an arbitrary function of the distance. *)
let distances =
  Law.law ~count:20 ~print "where it should be" cases (fun c ->
      let f s = 1. /. (1. +. s) in
      let far = if c.limit < infinity then c.limit else 60. in
      let integral rate _ =
        let n = 4000 in
        let h = far /. float_of_int n in
        let at i =
          let s = (float_of_int i +. 0.5) *. h in
          rate *. through rate s *. f s *. h
        in
        List.fold_left ( +. ) 0. (List.init n at)
      in
      let m =
        of_case { c with extinction = Rgb.add c.extinction (Rgb.grey 0.1) }
      in
      let expected = Rgb.mul c.albedo (each integral m.extinction far) in
      near
        (mean (fun u ->
             match Medium.sample m ~carried:c.carried ~limit:c.limit u with
             | Scattered { weight; distance } -> Rgb.scale (f distance) weight
             | Passed _ -> Rgb.black))
        expected
      && near
           (mean (fun u ->
                match
                  Medium.sample_within m ~carried:c.carried ~limit:c.limit u
                with
                | Some (s, weight) -> Rgb.scale (f s) weight
                | None -> Rgb.black))
           expected)

let sum (c : Rgb.t) = c.r +. c.g +. c.b

let kept =
  law "without absorption nothing of the sum is lost" (fun c ->
      let m = medium c.extinction c.extinction in
      List.for_all
        (fun u ->
          let weight =
            match Medium.sample m ~carried:c.carried ~limit:c.limit u with
            | Scattered { weight; _ } | Passed { weight } -> weight
          in
          Near.close (sum (Rgb.mul c.carried weight)) (sum c.carried))
        [ 0.; 0.1; 0.35; 0.8; Float.pred 1. ])

let within_limit =
  law "distances are within the way, weights finite" (fun c ->
      List.for_all
        (fun u ->
          (match
             Medium.sample (of_case c) ~carried:c.carried ~limit:c.limit u
           with
            | Scattered { distance; weight } ->
                distance >= 0. && distance < c.limit && Rgb.is_finite weight
            | Passed { weight } -> Rgb.is_finite weight)
          &&
          match
            Medium.sample_within (of_case c) ~carried:c.carried ~limit:c.limit u
          with
          | Some (s, weight) ->
              s >= 0. && s <= c.limit *. (1. +. 0x1p-50) && Rgb.is_finite weight
          | None -> true)
        [ 0.; 0x1p-60; 0.3; 0.34; 0.6; 0.7; Float.pred 1. ])

let one_colour () =
  let m = medium (Rgb.v 1. 2. 3.) (Rgb.v 1. 2. 3.) in
  List.iter
    (fun (carried, expected) ->
      match Medium.sample m ~carried ~limit:infinity 0.5 with
      | Scattered { distance; _ } ->
          Near.float "half of it" (log 2. /. expected) distance
      | Passed _ -> Alcotest.fail "it passes")
    [ (Rgb.v 1. 0. 0., 1.); (Rgb.v 0. 5. 0., 2.); (Rgb.v 0. 0. 0.1, 3.) ]

let scaled =
  law "a power of two leaves the weights" (fun c ->
      let k = 0x1p-30 in
      let m = of_case c in
      let less = medium (Rgb.scale k m.extinction) (Rgb.scale k m.scattering) in
      List.for_all
        (fun u ->
          let carried = c.carried in
          match
            ( Medium.sample m ~carried ~limit:c.limit u,
              Medium.sample less ~carried ~limit:(c.limit /. k) u )
          with
          | Passed a, Passed b -> Rgb.equal a.weight b.weight
          | Scattered a, Scattered b ->
              Rgb.equal a.weight b.weight && a.distance /. k = b.distance
          | Passed _, Scattered _ | Scattered _, Passed _ -> false)
        [ 0.1; 0.2; 0.5; 0.6; 0.9 ])

let sources () =
  let fog =
    Medium.of_fog
      {
        extinction = Rgb.v 1. 2. 4.;
        albedo = Rgb.v 0.5 1. 0.;
        anisotropy = 0.25;
        within = None;
      }
  in
  Near.rgb ~within:0. "fog scatters its albedo" (Rgb.v 0.5 2. 0.) fog.scattering;
  let body kind = Medium.of_material (Material.v kind) in
  let glass absorption =
    body
      (Glass
         {
           index = 1.5;
           color = Constant Rgb.white;
           absorption;
           dispersion = None;
         })
  in
  Alcotest.(check bool) "clear glass" true (Option.is_none (glass Rgb.black));
  (match glass (Rgb.v 0. 1. 0.) with
  | Some m ->
      Near.rgb ~within:0. "glass absorbs" (Rgb.v 0. 1. 0.) m.extinction;
      Near.rgb ~within:0. "and scatters nothing" Rgb.black m.scattering
  | None -> Alcotest.fail "glass that absorbs is no medium");
  match
    body
      (Translucent
         {
           index = 1.5;
           scattering = Rgb.v 1. 2. 3.;
           absorption = Rgb.v 4. 0. 1.;
           anisotropy = -0.5;
         })
  with
  | Some m -> Near.rgb ~within:0. "the sum" (Rgb.v 5. 2. 4.) m.extinction
  | None -> Alcotest.fail "a translucent body is no medium"

let suite =
  ( "media",
    [
      transmittance;
      passes;
      scatters;
      distances;
      kept;
      within_limit;
      Law.example "the colour that is carried decides" one_colour;
      scaled;
      Law.example "what fog, glass and milk are" sources;
    ] )
