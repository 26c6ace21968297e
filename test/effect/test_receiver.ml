open Candor_oracle
open Candor_space
open Candor_optics
open Candor_effect
open Candor_scene_made

let tame = QCheck2.Gen.pair (Draw.uniform 1e-9 10.) (Draw.uniform 1e-9 10.)

let shared =
  Law.law
    ~print:QCheck2.Print.(pair float float)
    "two ways share light" tame
    (fun (p, q) -> Lit.close (Receiver.power p q +. Receiver.power q p) 1.)

let ends () =
  Called.near "never" 0. (Receiver.power 0. 3.);
  Called.near "the only way" 1. (Receiver.power 3. 0.);
  Called.near "as likely" 0.5 (Receiver.power 1e300 1e300);
  Called.near "far likelier" 1. (Receiver.power 1e300 1e-300)

let matte = "(material (matte (color .6)))"

let on_surface ~goes_on =
  let s = Written.scene [ Called.camera; Called.ball matte ] in
  Receiver.of_vertex Scattering.matte ~goes_on
    (Lit.vertex (Lit.hit s (0., 0., 5.) (0., 0., -1.)) (Vec.v 0. 0. 1.))

let aslant = Dir.of_vec_or Dir.z (Vec.v 3. 0. 4.)

let surfaces () =
  let r = on_surface ~goes_on:true in
  Called.near "colour/π·cos" (0.48 /. Float.pi) (r.respond aslant).r;
  Called.near "cos/π" (0.8 /. Float.pi) (r.density aslant);
  Called.near "from behind" 0. (r.respond (Dir.neg aslant)).r;
  Called.near "where paths end" 0. ((on_surface ~goes_on:false).density aslant);
  Alcotest.(check bool)
    "rays leave the surface" true
    ((r.spawn (Vec.v 0. 0. 1.)).departure <> Nowhere)

let media () =
  let m =
    {
      Medium.extinction = Candor_colour.Rgb.white;
      scattering = Candor_colour.Rgb.white;
      anisotropy = 0.5;
    }
  in
  let along = Dir.neg Dir.z in
  let r goes_on =
    Receiver.in_medium m ~goes_on Path.start (Point.v 1. 2. 3.) ~along
  in
  let phase cos = 0.75 /. (4. *. Float.pi *. ((1.25 -. cos) ** 1.5)) in
  Called.near "light from ahead" (phase 1.) ((r true).respond along).g;
  Called.near "light from behind" (phase (-1.)) ((r true).respond Dir.z).g;
  Called.near "from the side" (phase 0.) ((r true).density Dir.x);
  Called.near "where paths end" 0. ((r false).density Dir.x);
  Alcotest.(check bool)
    "rays start in space" true
    (((r true).spawn (Vec.v 0. 0. 1.)).departure = Nowhere)

let suite =
  ( "receivers",
    [
      shared;
      Law.example "shares at the ends" ends;
      Law.example "surfaces send light on as they scatter" surfaces;
      Law.example "media as Henyey and Greenstein say" media;
    ] )
