open Candor_space
open Candor_colour
open Candor_sample
open Candor_optics
open Candor_oracle

let none =
  {
    Lobes.diffuse = Rgb.black;
    highlight = None;
    mirror = Rgb.black;
    gloss = None;
  }

let colour = Rgb.v 0.8 0.4 0.2
let matte = { none with diffuse = colour }

let phong =
  {
    matte with
    highlight = Some { specular = Rgb.v 0.1 0.3 0.5; shininess = 7. };
  }

let metal =
  { none with gloss = Some (Gloss.metal ~reflectance:colour ~roughness:0.3) }

let plastic roughness =
  {
    none with
    gloss = Some (Gloss.plastic (Coat.make ~index:1.5 ~roughness) ~color:colour);
  }

let unit x y z = Dir.of_vec_or Dir.z (Vec.v x y z)
let normal = unit (-0.4) 0.2 0.7
let view = unit 0.3 0.5 0.6
let value (s : Scattering.t) lobes = s.value lobes ~normal ~view

let both =
  [ ("matte alone", Scattering.matte); ("with gloss", Scattering.glossy) ]

let each f = List.iter (fun (name, s) -> f name s) both

let matte_value () =
  each (fun name s ->
      let toward = unit 0.2 0.9 0.4 in
      let cos = Dir.dot normal toward in
      Near.rgb name (Rgb.scale (cos /. Float.pi) colour) (value s matte ~toward);
      Near.rgb (name ^ ", from below") Rgb.black
        (value s matte ~toward:(Dir.neg toward));
      Near.rgb
        (name ^ ", the highlight from below")
        Rgb.black
        (value s phong ~toward:(Dir.neg toward)))

(* Where the light is mirrored h is n, and half of it where h is at 60°. *)
let highlight () =
  let at ~view ~toward ~shininess =
    let specular = Rgb.v 0.5 0.25 1. in
    let lobes = { none with highlight = Some { specular; shininess } } in
    Scattering.matte.value lobes ~normal:Dir.z ~view ~toward
  in
  let s = Rgb.v 0.5 0.25 1. in
  Near.rgb "mirrored" s
    (at ~view:(unit 0.6 0. 0.8) ~toward:(unit (-0.6) 0. 0.8) ~shininess:50.);
  let turned =
    unit (sin (2. *. Float.pi /. 5.)) 0. (cos (2. *. Float.pi /. 5.))
  in
  Near.rgb ~within:1e-12 "36 degrees off"
    (Rgb.scale (cos (Float.pi /. 5.) ** 3.) s)
    (at ~view:Dir.z ~toward:turned ~shininess:3.);
  Near.rgb "shininess 0 is 1 everywhere" s
    (at ~view:Dir.z ~toward:turned ~shininess:0.)

let gloss_value () =
  let toward = unit 0.2 0.9 0.4 in
  List.iter
    (fun lobes ->
      let gloss = Option.get lobes.Lobes.gloss in
      Near.rgb "gloss"
        (Gloss.value gloss ~normal ~view ~toward)
        (value Scattering.glossy lobes ~toward);
      Near.float "density"
        (Gloss.density gloss ~normal ~view ~toward)
        (Scattering.glossy.density lobes ~normal ~view ~toward))
    [ metal; plastic 0.2; plastic 0. ];
  Near.rgb "matte knows no gloss" Rgb.black
    (value Scattering.matte metal ~toward)

let is_black () =
  let check name expected s lobes =
    Alcotest.(check bool) name expected (s.Scattering.is_black lobes)
  in
  each (fun name s ->
      check (name ^ ": nothing") true s none;
      check (name ^ ": a mirror") true s { none with mirror = Rgb.white };
      check (name ^ ": matte") false s matte;
      check (name ^ ": a highlight") false s { phong with diffuse = Rgb.black });
  check "gloss" false Scattering.glossy metal;
  check "gloss unknown" true Scattering.matte metal

let draw (s : Scattering.t) lobes i =
  s.sample lobes ~normal ~view ~choice:(Directions.uniform i 0)
    { Pattern.u = Directions.uniform i 1; v = Directions.uniform i 2 }

(* The highlight is for lights only, and not sampled. *)
let cases =
  [
    ("matte", Scattering.matte, matte);
    ("matte beside gloss", Scattering.glossy, matte);
    ("phong", Scattering.matte, phong);
    ("metal", Scattering.glossy, metal);
    ("plastic", Scattering.glossy, plastic 0.3);
    ("smooth plastic", Scattering.glossy, plastic 0.);
  ]

let weights () =
  List.iter
    (fun (name, s, lobes) ->
      for i = 0 to 999 do
        match draw s lobes i with
        | None -> ()
        | Some { Gloss.toward; weight; density } ->
            Near.float ~within:1e-9 (name ^ ", density")
              (s.Scattering.density lobes ~normal ~view ~toward)
              density;
            let plain = { lobes with Lobes.highlight = None } in
            Near.rgb ~within:1e-9 (name ^ ", weight")
              (Rgb.scale (1. /. density) (value s plain ~toward))
              weight
      done)
    cases

let follows () =
  List.iter
    (fun (name, s, lobes) ->
      let around = Directions.reflected ~normal ~view ~width:0.5 in
      Directions.follows name around
        ~density:(fun toward ->
          s.Scattering.density lobes ~normal ~view ~toward)
        (fun i -> Option.map (fun s -> s.Gloss.toward) (draw s lobes i)))
    cases

let no_sample () =
  each (fun name s ->
      let lobes = { phong with diffuse = Rgb.black } in
      Alcotest.(check bool) name true (Option.is_none (draw s lobes 1));
      Near.float name 0. (s.density lobes ~normal ~view ~toward:normal))

let suite =
  ( "scattering",
    [
      Law.example "a matte surface sends colour cos/pi" matte_value;
      Law.example "a highlight is specular (n.h)^shininess" highlight;
      Law.example "gloss is what Gloss says" gloss_value;
      Law.example "what returns nothing is known" is_black;
      Law.example "a sample's weight is value/density, highlights apart" weights;
      Law.example "samples are as dense as they say" follows;
      Law.example "what is black but for a highlight is not sampled" no_sample;
    ] )
