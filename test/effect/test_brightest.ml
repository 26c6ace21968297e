open Candor_colour
open Candor_scene
open Candor_effect
open Candor_trace
open Candor_oracle
open Candor_scene_made

(* {1 Known bounds} *)

let bound forms = Brightest.of_scene (Lit.scene forms)

let check name (expected : Rgb.t) forms =
  match bound forms with
  | At_most most -> Lit.check_close ~within:1e-9 name expected most
  | Unbounded why -> Alcotest.failf "%s: unbounded, %s" name why

let grey name expected = check name (Rgb.grey expected)
let plane = "(box (min -9 0 -9) (max 9 0 9) "
let floor material = plane ^ "(material " ^ material ^ "))"
let sun = "(light (directional (direction 0 -1 0) (irradiance 2)))"
let lamp = "(light (point (at 0 2 0) (intensity 8)))"
let sky = "(background (gradient (down .25) (up .5)))"
let dark = 1. /. Float.pi

let surfaces () =
  grey "the sky" 0.5 [ sky ];
  grey "matte in the sun" dark [ sun; floor "(matte (color .5))" ];
  grey "under a lamp" dark [ lamp; floor "(matte (color .5))" ];
  grey "two lights and ambient light"
    (1. +. (2. *. dark))
    [ sun; lamp; "(ambient 2)"; floor "(matte (color .5))" ];
  grey "a highlight" (dark +. 0.5)
    [ sun; floor "(phong (color .5) (specular .25) (shininess 9))" ];
  grey "glaze on what the sun shines at" (1.25 *. dark)
    [ sun; floor "(glazed (color .5) (mirror .2))" ];
  grey "a mirror adds nothing" 0.5 [ sky; sun; floor "(mirror)" ];
  grey "a mirror that glows" 4.
    [ sky; floor "(mirror (color .75) (emission 1))" ];
  grey "glass" 0.5 [ sky; sun; floor "(glass (index 1.5))" ];
  check "by colour" (Rgb.v 1. 0. 6.)
    [
      floor "(emitter (radiance (rgb 1 0 5)))";
      "(sphere (center 0 9 0) (radius 1) (material (emitter (radiance (rgb 0 0 \
       6)))))";
    ]

let area =
  "(sphere (center 0 9 0) (radius 1) (material (emitter (radiance 6))))"

let indirect = "(indirect-light)"

let areas () =
  grey "a lamp is the brightest" 6. [ area; floor "(matte (color 1))" ];
  grey "where more falls on a floor" 7.
    [ area; "(ambient 1)"; floor "(matte (color 1))" ];
  grey "what bounces is not above it" 6.
    [ area; indirect; floor "(matte (color 1))" ];
  grey "smooth plastic is lit by the lamp below its coat" 6.
    [ area; sky; floor "(plastic (color .1) (index 1.5) (roughness 0))" ];
  grey "light that bounces from all sides" (4. *. dark)
    [ sun; indirect; floor "(matte (color .6666666666666666))" ];
  grey "a lamp in metal" 6.
    [ area; floor "(metal (reflectance .9) (roughness .3))" ]

let media () =
  let fog ?(within = "(within (min -1 0 -1) (max 1 1 1))") albedo =
    Printf.sprintf "(fog (extinction 1) (albedo %g) (anisotropy 0) %s)" albedo
      within
  in
  grey "fog that takes away" 0.5 [ sky; lamp; fog 0. ];
  grey "fog in the sun" (0.5 *. 2. *. dark /. 4.) [ sun; fog 0.5 ];
  grey "again" (0.5 *. 2. *. dark /. 4. /. 0.5) [ sun; indirect; fog 0.5 ];
  grey "far from a lamp"
    (2. *. dark /. 4.)
    [ lamp; fog 1. ~within:"(within (min -1 -2 -1) (max 1 0 1))" ];
  grey "jade" 0.5
    [
      sky;
      lamp;
      "(sphere (center 0 -3 0) (radius 1) (material (translucent (index 1.5) \
       (scattering 2) (absorption 1))))";
    ]

let wavelengths () =
  grey "a prism" (0.5 *. 1.125)
    [ sky; floor "(glass (index 1.5) (dispersion 30))" ];
  let n = 100_000 in
  let at i =
    Dispersion.(colour (wavelength ((float_of_int i +. 0.5) /. float_of_int n)))
  in
  let sum =
    Seq.fold_left Rgb.add Rgb.black (Seq.map at (Seq.take n (Seq.ints 0)))
  in
  let mean = Rgb.largest sum /. float_of_int n in
  if mean > 1.125 then Alcotest.failf "the mean of all colours is %g" mean

let unbounded name why forms =
  match bound forms with
  | At_most most -> Alcotest.failf "%s: at most %s" name (Rgb.show most)
  | Unbounded w -> Alcotest.(check string) name why w

let reasons () =
  unbounded "a mirror that shines"
    "mirror surface [made.scene:3:1] adds light and passes on all that it gets"
    [ floor "(mirror (emission 1))" ];
  unbounded "white paint in the sun"
    "material paint [made.scene:5:1] adds light and passes on all that it gets"
    [
      sun;
      indirect;
      "(material paint (matte (color 1)))";
      plane ^ "(material paint))";
    ];
  unbounded "a lamp on a surface"
    "the point light [made.scene:3:1] may shine from no distance, without bound"
    [ lamp; "(quadric (plane (normal 0 1 0) (offset 2)))" ];
  unbounded "a lamp in fog"
    "the point light [made.scene:3:1] may shine from no distance, without bound"
    [ lamp; "(fog (extinction 1) (albedo .5))" ];
  unbounded "a lamp in jade"
    "the point light [made.scene:3:1] may shine inside translucent bodies"
    [
      lamp;
      "(sphere (center 0 2 0) (radius 1) (material (translucent (index 1.5) \
       (scattering 2) (absorption 1))))";
    ];
  grey "a lamp that nothing shows" 0.5
    [
      sky;
      lamp;
      "(quadric (plane (normal 0 1 0) (offset 2)) (material (mirror)))";
    ]

(* {1 Scenes drawn at random} *)

(* Rounding is allowed for. *)
let within most x = x <= most *. (1. +. 1e-9)

let all_within (most : Rgb.t) (c : Rgb.t) =
  within most.r c.r && within most.g c.g && within most.b c.b

(* Deep paths, cut nowhere near the brightest. *)
let deep (s : Scene.t) =
  { s with settings = { s.settings with depth = Some 12; cutoff = 0. } }

let samples (s : Scene.t) f =
  let pixel = Pixel.compile s and tally = Tally.make () in
  List.for_all
    (fun i ->
      let x = i mod s.width and y = i / s.width in
      List.for_all
        (fun sample -> f (Pixel.sample pixel tally ~x ~y ~sample))
        (List.init s.settings.spp Fun.id))
    (List.init (s.width * s.height) Fun.id)

let no_sample_above s =
  let s = deep s in
  match Brightest.of_scene s with
  | Unbounded _ -> true
  | At_most most -> samples s (all_within most)

let law ?(count = 300) name gen f = Law.law ~count ~print:Drawn.show name gen f

let certain s =
  QCheck2.assume (not (Plan.is_random (Plan.of_scene s)));
  no_sample_above s

(* Of what is left to chance the mean is bounded, not each sample. *)
let mean_above (s : Scene.t) n =
  let s = { s with settings = { s.settings with spp = n } } in
  let pixel = Pixel.compile s and tally = Tally.make () in
  let at i =
    Pixel.sample pixel tally ~x:(s.width / 2) ~y:(s.height / 2) ~sample:i
  in
  let samples = List.init n at in
  let n = float_of_int n in
  fun part most ->
    let mean = List.fold_left (fun sum c -> sum +. part c) 0. samples /. n in
    let square c = (part c -. mean) ** 2. in
    let squares = List.fold_left (fun sum c -> sum +. square c) 0. samples in
    within most (mean -. (5. *. sqrt squares /. n))

let by_chance s =
  match Brightest.of_scene s with
  | Unbounded _ -> true
  | At_most most ->
      let above = mean_above s 128 in
      above (fun c -> c.r) most.r
      && above (fun c -> c.g) most.g
      && above (fun c -> c.b) most.b

let often () =
  let scenes =
    QCheck2.Gen.generate ~n:200
      ~rand:(Random.State.make [| 7 |])
      (Rich.scene Drawn.Loose)
  in
  let bounded s =
    match Brightest.of_scene s with At_most _ -> true | Unbounded _ -> false
  in
  let n = List.length (List.filter bounded scenes) in
  if n < 50 then Alcotest.failf "only %d of 200 scenes have a bound" n

let suite =
  ( "brightest",
    [
      Law.example "what surfaces add and pass on" surfaces;
      Law.example "area lights" areas;
      Law.example "fog and cloudy bodies" media;
      Law.example "light that takes a wavelength" wavelengths;
      Law.example "without a bound: why, and where" reasons;
      law "no sample of a drawn scene is brighter" (Drawn.scene Round) certain;
      law "nor of one of loose numbers" (Drawn.scene Loose) certain;
      law "nor the mean of samples that are left to chance" ~count:200
        (Rich.scene Loose) by_chance;
      Law.example "many scenes have a bound" often;
    ] )
