open Candor_space
open Candor_sample
open Candor_oracle
open QCheck2

let pi = Float.pi
let z_of (d : Dir.t) = (d :> Vec.t).z
let spread = Agreement.steps 16 (-1.) 1.

(* {1 Samples against densities} *)

let discs () =
  let edges = Agreement.steps 16 0. 1. in
  let bin i =
    let d = Warp.disk (Agreement.position i) in
    let r2 = (d.x *. d.x) +. (d.y *. d.y) in
    (Agreement.(stretch edges r2) * Agreement.sectors) + Agreement.sector d
  in
  Chi_square.(even "the disk" (count (16 * Agreement.sectors) 100_000 bin))

let hemispheres () =
  Agreement.sphere "cosine" spread ~sample:Warp.cosine_hemisphere
    ~density:(fun d -> Warp.cosine_hemisphere_density (z_of d))

let spheres () =
  Agreement.sphere "sphere" spread ~sample:Warp.sphere ~density:(fun _ ->
      0.25 /. pi)

(* Cones whose rim is an edge between zones. *)
let cones () =
  List.iter
    (fun one_minus_cos ->
      let density d =
        if z_of d >= 1. -. one_minus_cos then Warp.cone_density ~one_minus_cos
        else 0.
      in
      let inner = Agreement.steps 8 (1. -. one_minus_cos) 1. in
      let edges = Array.append [| -1. |] inner in
      Agreement.sphere
        (Printf.sprintf "cone %g" one_minus_cos)
        edges ~sample:(Warp.cone ~one_minus_cos) ~density)
    [ 0x1p-10; 0.25; 1.; 1.75 ]

(* 1 - cos is half of x^2 + y^2 there. *)
let narrow_cones () =
  List.iter
    (fun one_minus_cos ->
      let bin i =
        let d = (Warp.cone ~one_minus_cos (Agreement.position i) :> Vec.t) in
        let h = ((d.x *. d.x) +. (d.y *. d.y)) /. 2. /. one_minus_cos in
        let part = Agreement.(stretch (steps 16 0. 1.) h) in
        if h > 1. then Alcotest.failf "outside of the cone %h" one_minus_cos;
        (part * Agreement.sectors) + Agreement.sector d
      in
      Chi_square.(
        even
          (Printf.sprintf "cone %h" one_minus_cos)
          (count (16 * Agreement.sectors) 100_000 bin)))
    [ 0x1p-40; 0x1p-60; 0x1p-300 ]

(* Zones that halve towards both poles. *)
let polar_edges =
  let near = Array.init 26 (fun i -> 1. -. Float.ldexp 1. (-i)) in
  let far = Array.init 25 (fun i -> -.near.(25 - i)) in
  Array.concat [ [| -1. |]; far; near; [| 1. |] ]

let hazes () =
  List.iter
    (fun g ->
      Agreement.sphere
        (Printf.sprintf "g = %g" g)
        polar_edges
        ~sample:(Warp.henyey_greenstein_sample ~g)
        ~density:(Warp.henyey_greenstein ~g Dir.z))
    [ -0.999; -0.6; -0x1p-30; 0.; 0x1p-60; 0x1p-10; 0.3; 0.85; 0.999 ]

let mean_cosine () =
  List.iter
    (fun g ->
      let n = 4096 in
      let key = Key.v ~seed:1 ~x:0 ~y:0 ~sample:0 ~bounce:0 Film in
      let sum = ref 0. in
      for i = 0 to n - 1 do
        let p = Sobol.pair ~key i in
        sum := !sum +. z_of (Warp.henyey_greenstein_sample ~g p)
      done;
      Alcotest.(check (float 1e-3))
        (Printf.sprintf "g = %g" g)
        g
        (!sum /. float_of_int n))
    [ -0.9999; -0.5; 0.; 1e-9; 0.5; 0.9; 0.9999 ]

let flights () =
  List.iter
    (fun rate ->
      let edges = Array.map (fun t -> t /. rate) (Agreement.steps 32 0. 16.) in
      Agreement.line
        (Printf.sprintf "rate %g" rate)
        edges ~sample:(Warp.exponential ~rate)
        ~density:(Warp.exponential_density ~rate))
    [ 0x1p-40; 0.3; 7.; 1e30 ]

(* {1 Laws} *)

let unit =
  Gen.oneof
    [
      Draw.uniform 0. (Float.pred 1.);
      Draw.wide (-300.) (-1.);
      Gen.map (fun x -> 1. -. x) (Draw.wide (-16.) (-1.));
      Draw.pick
        [ 0.; Float.pred 1.; 0.5; Float.pred 0.5; 0.25; 5e-324; 0x1p-53 ];
    ]

let unit = Gen.map (fun u -> Float.min u (Float.pred 1.)) unit
let place = Gen.map2 (fun u v -> { Pattern.u; v }) unit unit
let show { Pattern.u; v } = Printf.sprintf "(%h, %h)" u v
let law name gen print f = Law.law ~count:3000 ~print name gen f
let near e a b = Float.abs (a -. b) <= e
let is_unit (d : Dir.t) = near 0x1p-50 (Vec.norm (d :> Vec.t)) 1.

let with_number gen =
  (Gen.pair gen place, fun (x, p) -> Printf.sprintf "%h at %s" x (show p))

let hemisphere_law p =
  let d = Warp.cosine_hemisphere p in
  is_unit d && z_of d > 0. && Warp.cosine_hemisphere_density (z_of d) > 0.

let disk_law p =
  let d = Warp.disk p in
  d.z = 0. && Vec.norm d <= 1.

let width =
  Gen.oneof
    [ Draw.uniform 0x1p-60 2.; Draw.wide (-300.) 0.; Draw.pick [ 1.; 2. ] ]

let cone_law (one_minus_cos, p) =
  let d = Warp.cone ~one_minus_cos p in
  let { Vec.x; y; z } = (d :> Vec.t) in
  let h = if z > 0. then ((x *. x) +. (y *. y)) /. (1. +. z) else 1. -. z in
  is_unit d && h <= one_minus_cos *. (1. +. 0x1p-48)

let anisotropy =
  let close = Gen.map (fun x -> 1. -. x) (Draw.wide (-15.) (-1.)) in
  Draw.signed
    (Gen.oneof
       [ Draw.uniform 0. 0.999; close; Draw.wide (-300.) (-1.); Gen.return 0. ])

(* The density at what is sampled is its formula at the cosine whose distribution
   function is u, 1 + g xi over 1 - g^2 to the third. *)
let haze_law (g, p) =
  let d = Warp.henyey_greenstein_sample ~g p in
  let f = Warp.henyey_greenstein ~g Dir.z d in
  let a = Float.abs g in
  let k = 1. -. a +. (2. *. a *. p.u) in
  let expected =
    k *. k *. k /. (4. *. pi *. (((1. -. a) *. (1. +. a)) ** 2.))
  in
  (* What a direction cannot hold of an angle, in units of the peak's width. *)
  let blur = 0x1p-48 /. (1. -. a) in
  is_unit d && near (expected *. (0x1p-44 +. (4. *. blur))) f expected

let symmetric (g, p) =
  let f = Frame.of_dir (Warp.sphere p) in
  let w' = Warp.to_world f (Warp.cone ~one_minus_cos:0.5 p :> Vec.t) in
  let value = Warp.henyey_greenstein ~g f.w w' in
  Float.equal value (Warp.henyey_greenstein ~g w' f.w)
  && Float.equal value (Warp.henyey_greenstein ~g:(-.g) (Dir.neg f.w) w')

let rate = Gen.oneof [ Draw.wide (-30.) 30.; Draw.power (-300) 300 ]

let flight_law (rate, { Pattern.u; _ }) =
  let t = Warp.exponential ~rate u in
  let back = -.Float.expm1 (-.(rate *. t)) in
  let underflows = u > 0. && t < 0x1p-1000 in
  t >= 0. && Float.is_finite t
  && (underflows
     || near (u *. 0x1p-50) back u
        && Float.equal (Warp.exponential ~rate:(0.25 *. rate) u) (4. *. t))

let frames_law (p, q) =
  let f = Frame.of_dir (Warp.sphere p) in
  let d = (Warp.sphere q :> Vec.t) in
  let w = Warp.to_world f d in
  is_unit w
  && Vec.largest (Vec.sub (Warp.to_local f w) d) <= 0x1p-49
  && near 0x1p-49 (Dir.dot w f.w) d.z

let versed (s, _) =
  let h = Warp.one_minus_cos ~sin2:s in
  let sin2 = h *. (2. -. h) in
  0. <= h && h <= 1. && near (Float.max (0x1p-50 *. s) 5e-324) sin2 s

let worlds () =
  let f = Frame.of_dir Dir.x in
  let d = Warp.to_world f Vec.zero in
  Alcotest.(check bool) "no direction" true (Dir.equal d Dir.x);
  let x = Warp.to_world f (Vec.v 0. 0. 3.) in
  Alcotest.(check bool) "its own axis" true (Dir.equal x Dir.x)

let suite =
  let law2 name gen f =
    let gen, print = with_number gen in
    law name gen print f
  in
  ( "warps",
    [
      Law.example "the disk is filled evenly" discs;
      Law.example "the hemisphere has the density of its cosine" hemispheres;
      Law.example "the sphere is covered evenly" spheres;
      Law.example "cones are filled evenly" cones;
      Law.example "cones of 2^-40, 2^-60, 2^-300 are filled evenly" narrow_cones;
      Law.example "scattered directions have their density" hazes;
      Law.example "the mean cosine of scattering is g" mean_cosine;
      Law.example "free flights have their density" flights;
      law "G25: directions of the hemisphere are above, with density > 0" place
        show hemisphere_law;
      law "points of the disk are in it" place show disk_law;
      law2 "directions are in their cone, however narrow" width cone_law;
      law2 "scattering is dense where it is sampled, for g up to 1 - 1e-15"
        anisotropy haze_law;
      law2 "scattering is symmetric, and backwards for -g" anisotropy symmetric;
      law2 "free flights invert their distribution, and scale" rate flight_law;
      law "to_local undoes to_world" (Gen.pair place place)
        (fun (p, q) -> show p ^ show q)
        frames_law;
      law2 "1 - cos from the sine is accurate" unit versed;
      Law.example "to_world is total" worlds;
    ] )
