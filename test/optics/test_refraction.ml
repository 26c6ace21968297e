open Candor_space
open Candor_optics
open Candor_oracle
open QCheck2

let index =
  Gen.oneof
    [
      Draw.uniform 1. 3.;
      Draw.pick [ 1.; 1.000293; 1.31; 4. /. 3.; 1.5; 1.5168; 2.417 ];
      Draw.signed (Draw.wide (-8.) 8.) |> Gen.map Float.abs;
    ]

let boundary =
  let open Gen in
  let* from = index and* into = index and* k = int_range 1 52 in
  let* into =
    Draw.either 30 (return (from *. (1. -. Float.ldexp 1. (-k)))) (return into)
  in
  let* turned = bool in
  let b = { Refraction.from; into } in
  return (if turned then Refraction.reverse b else b)

let cosine =
  Gen.oneof
    [
      Draw.uniform 0. 1.;
      Draw.wide (-20.) 0.;
      Gen.map (fun x -> 1. -. x) (Draw.wide (-16.) 0.);
      Draw.nudged (Draw.pick [ 0.; 1. ]);
      Draw.pick [ -1e-17; -0x1p-52; 1. +. 0x1p-52; 0x1p-200 ];
    ]

let dense { Refraction.from; into } =
  if from = into then { Refraction.from; into = 0.75 *. from }
  else { from = Float.max from into; into = Float.min from into }

let critical { Refraction.from; into } =
  let open Exact in
  let sine = q into / q from in
  Q.to_float (sqrt (one - (sine * sine)))

(* Cosines from 1e-3 to no ulp away from the critical angle. *)
let planted =
  let open Gen in
  let+ b = map dense boundary
  and+ e = Draw.signed (Draw.wide (-17.) (-3.))
  and+ k = int_range (-3) 3
  and+ ulps = bool in
  let c = critical b in
  (b, if ulps then c +. (float_of_int k *. Exact.ulp c) else c *. (1. +. e))

let anywhere = Gen.(oneof [ pair boundary cosine; planted ])

let show ({ Refraction.from; into }, c) =
  Printf.sprintf "from %h into %h at %h" from into c

let clamp c = if c < 0. then 0. else if c > 1. then 1. else c

let discriminant { Refraction.from; into } c =
  let open Exact in
  let n = q from and n' = q into and c = q (clamp c) in
  (n' * n') - (n * n * (one - (c * c)))

let exact_discriminant (b, c) =
  let k = Refraction.discriminant b c and truth = discriminant b c in
  Int.equal (Float.compare k 0.) (Q.sign truth)
  && (Q.sign truth = 0 || Exact.ulps_off k truth <= 2.)

(* Fresnel's equations as every book has them. *)
let fresnel { Refraction.from; into } c =
  let open Exact in
  let n = q from and n' = q into and c = q (clamp c) in
  let c' = sqrt (discriminant { Refraction.from; into } (Q.to_float c)) / n' in
  let part a b =
    let amplitude = (a - b) / (a + b) in
    amplitude * amplitude
  in
  (part (n * c) (n' * c') + part (n' * c) (n * c')) / two

let exact_reflectance (b, c) =
  let r = Refraction.reflectance b c in
  if b.from = b.into then r = 0.
  else if Q.sign (discriminant b c) < 0 then r = 1.
  else
    let truth = fresnel b c in
    Q.leq (Q.abs Exact.(q r - truth)) Exact.(power (-47) * truth)

let energy (b, c) =
  let r = Refraction.reflectance b c in
  0. <= r && r <= 1.

(* A unit normal, and a unit direction against it at about a cosine. *)
let meeting =
  let open Gen in
  let* b, c = anywhere in
  let* normal = Draw.unit in
  let* aside = Draw.across normal in
  let c = clamp c in
  let sine = Stdlib.sqrt ((1. -. c) *. (1. +. c)) in
  let d = Vec.sub (Vec.scale sine aside) (Vec.scale c normal) in
  let dir a = Dir.of_vec_or Dir.x a in
  return (b, dir normal, dir d)

let show_meeting (b, (normal : Dir.t), (d : Dir.t)) =
  Printf.sprintf "%s, normal %s along %s"
    (show (b, -.Dir.dot normal d))
    (Draw.show_vec (normal :> Vec.t))
    (Draw.show_vec (d :> Vec.t))

let vec (d : Dir.t) = Exact.vec (d :> Vec.t)

(* |from (d x n) - into (t x n)|, beside the larger index. *)
let snell_error { Refraction.from; into } normal d t =
  let normal = vec normal in
  let tangent n a = Exact.(scale (q n) (cross a normal)) in
  let off = Exact.sub (tangent from (vec d)) (tangent into (vec t)) in
  Q.to_float (Exact.largest off) /. Float.max from into

let snell (({ Refraction.from; into } as b), normal, d) =
  let c = -.Dir.dot normal d and bend = Float.max 1. (from /. into) in
  let k = discriminant b c in
  match Refraction.at b ~normal d with
  | Total_reflection -> from <> into && Q.sign k < 0
  | Transmitted { direction = t; reflectance } ->
      let length2 = Exact.dot (vec t) (vec t) in
      let depth = Q.to_float (Exact.sqrt k) /. into in
      (from = into || Q.sign k >= 0)
      && reflectance = Refraction.reflectance b c
      && snell_error b normal d t <= 0x1p-49 *. bend
      && Float.abs (Dir.dot normal t +. depth) <= 0x1p-49 *. bend *. bend
      && Q.leq (Q.abs Exact.(length2 - one)) (Exact.power (-50))

(* Close to grazing, and between very different media, a rounding error turns
   the light far. *)
let alike { Refraction.from; into } = from < 8. *. into && into < 8. *. from
let tame b c = alike b && c > 0x1p-10

let comes_back b normal d direction reflectance =
  let back =
    Refraction.(at (reverse b)) ~normal:(Dir.neg normal) (Dir.neg direction)
  in
  match back with
  | Total_reflection -> false
  | Transmitted back ->
      let off = Vec.add (back.direction :> Vec.t) (d : Dir.t :> Vec.t) in
      Vec.largest off <= 0x1p-30
      && Near.close ~within:0x1p-26 back.reflectance reflectance

let reversible (b, normal, d) =
  match Refraction.at b ~normal d with
  | Total_reflection -> true
  | Transmitted { direction; reflectance } ->
      (not (tame b (-.Dir.dot normal d)))
      || comes_back b normal d direction reflectance

(* Many of these cosines round to above 1. *)
let head_on_case = Gen.pair boundary (Gen.map (Dir.of_vec_or Dir.x) Draw.unit)

let head_on (b, (normal : Dir.t)) =
  let finite (d : Dir.t) = Vec.is_finite (d :> Vec.t) in
  match Refraction.at b ~normal (Dir.neg normal) with
  | Total_reflection -> not (alike b)
  | Transmitted { direction; reflectance } ->
      (not (alike b))
      || finite direction
         && Near.close reflectance (Refraction.reflectance b 1.)
         && Near.close (Dir.dot direction normal) (-1.)

let glass = { Refraction.from = 1.; into = 1.5 }
let check name = Alcotest.(check (float 0.)) name
let near name = Alcotest.(check (float 1e-15)) name

let near_critical () =
  let b = Refraction.reverse glass in
  List.iter
    (fun e ->
      let c = critical b *. (1. +. e) in
      let name = Printf.sprintf "critical (1 + %g)" e in
      Alcotest.(check bool) name true (exact_discriminant (b, c));
      Alcotest.(check bool) name (e < 0.) (Refraction.discriminant b c < 0.))
    [ -1e-3; -1e-8; -1e-12; -1e-15; 1e-15; 1e-12; 1e-8; 1e-3 ]

let total () =
  let b = Refraction.reverse glass in
  let c = critical b in
  let slanting c =
    Dir.of_vec_or Dir.z (Vec.v (sqrt (1. -. (c *. c))) 0. (-.c))
  in
  List.iter
    (fun c ->
      check "all of it is reflected" 1. (Refraction.reflectance b c);
      match Refraction.at b ~normal:Dir.z (slanting c) with
      | Total_reflection -> ()
      | Transmitted _ -> Alcotest.failf "transmitted at %h" c)
    [ 0.; 1e-300; 1e-17; 0.5; c *. (1. -. 1e-15) ];
  let just_under = Refraction.reflectance b (c *. (1. +. 1e-15)) in
  if not (just_under < 1. && just_under > 1. -. 1e-6) then
    Alcotest.failf "%h just within the critical angle" just_under

let ends () =
  near "straight on" 0.04 (Refraction.reflectance glass 1.);
  near "straight on, from inside" 0.04
    (Refraction.reflectance (Refraction.reverse glass) 1.);
  near "grazing" 1. (Refraction.reflectance glass 0.);
  let as_at c c' =
    check
      (Printf.sprintf "as at %g" c)
      (Refraction.reflectance glass c)
      (Refraction.reflectance glass c')
  in
  List.iter (as_at 1.) [ 1. +. 0x1p-52; 1.5; infinity ];
  List.iter (as_at 0.) [ -0.; -1e-17; -0.5; neg_infinity ];
  let same = { Refraction.from = 1.3; into = 1.3 } in
  List.iter
    (fun c -> check "equal indices" 0. (Refraction.reflectance same c))
    [ -1e-17; -0.; 0.; 5e-324; 0.3; 1.; 1. +. 0x1p-52 ]

(* At Brewster's angle, tan a = 3/2, one polarisation is not reflected: what is
   left is half of ((4 - 9)/(4 + 9))^2. *)
let brewster () =
  near "half the light of one polarisation" (25. /. 338.)
    (Refraction.reflectance glass (2. /. sqrt 13.))

let straight () =
  List.iter
    (fun b ->
      match Refraction.at b ~normal:Dir.y (Dir.neg Dir.y) with
      | Total_reflection -> Alcotest.fail "reflected"
      | Transmitted { direction; reflectance = _ } ->
          Alcotest.(check bool) "on" true (Dir.equal direction (Dir.neg Dir.y)))
    [ glass; Refraction.reverse glass; { from = 2.; into = 2. } ]

let law name = Law.law ~count:20000 ~print:show name
let meeting_law name = Law.law ~count:10000 ~print:show_meeting name meeting

let suite =
  ( "refraction",
    [
      Law.example "G13: glass near its critical angle" near_critical;
      law
        "G13: the discriminant is within 2 ulps and its sign exact, next to \
         critical angles"
        planted exact_discriminant;
      law "G13: the discriminant is within 2 ulps and its sign exact, anywhere"
        anywhere exact_discriminant;
      Law.example "G14: beyond the critical angle all is reflected, never nan"
        total;
      meeting_law
        "G14: light is transmitted by Snell's law or totally reflected, exactly"
        snell;
      Law.law ~count:5000
        ~print:(fun (b, n) -> show_meeting (b, n, Dir.neg n))
        "G11: light straight on passes, though its cosine be above 1"
        head_on_case head_on;
      Law.example
        "G15: cosines beyond 0 and 1 count as these; equal indices reflect \
         nothing"
        ends;
      law "G15: reflectance is in [0;1]" anywhere energy;
      law "reflectance is Fresnel's within 2^-47" anywhere exact_reflectance;
      Law.example "one polarisation vanishes at Brewster's angle" brewster;
      Law.example "light straight on goes straight on" straight;
      meeting_law "transmitted light sent back returns, as much reflected"
        reversible;
    ] )
