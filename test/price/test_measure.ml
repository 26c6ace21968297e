open Candor_oracle
open Candor_scene_made
open Candor_trace
open Candor_image
open Candor_cost

let scene =
  Written.(
    scene
      [
        "(image (size 16 12)) (render (spp 4))";
        flat_camera;
        "(background .3)";
        "(light (point (at 2 3 5) (intensity 40)))";
        "(sphere (center 0 0 0) (radius .6))";
      ])

let never () = false
let all = Subset.make ~width:16 ~height:12 ~seed:3 ~pixels:1000

let found ?(domains = 1) ?(stop = never) subset =
  Measure.run ~domains ~stop subset (Pixel.compile scene)

let whole = Option.get (Candor_render.Render.run (Pixel.compile scene) scene)

let same () =
  match found all with
  | None -> Alcotest.fail "it was stopped"
  | Some m ->
      Alcotest.(check bool)
        "picture" true
        (Picture.equal m.picture whole.picture)

let subset () =
  let few = Subset.make ~width:16 ~height:12 ~seed:3 ~pixels:20 in
  match found few with
  | None -> Alcotest.fail "it was stopped"
  | Some m ->
      for i = 0 to Subset.count few - 1 do
        let x, y = Subset.pixel few i and width = Subset.width few in
        let a = Picture.pixel m.picture (i mod width) (i / width)
        and b = Picture.pixel whole.picture x y in
        Alcotest.(check bool) "pixel" true (Candor_colour.Rgb.equal a b);
        Alcotest.(check (float 0.))
          "shown"
          (Candor_colour.Display.encode b.g)
          (Float.Array.get m.shown ((3 * i) + 1))
      done;
      if not (m.seconds > 0. && m.rays_per_pixel >= 1.) then
        Alcotest.failf "%g s, %g rays" m.seconds m.rays_per_pixel

let parallel () =
  let picture domains =
    Option.map (fun (m : Measure.t) -> m.picture) (found ~domains all)
  in
  Alcotest.(check bool)
    "the same bits" true
    (Option.equal Picture.equal (picture 1) (picture 3))

let stopped () =
  Alcotest.(check bool)
    "nothing" true
    (Option.is_none (found ~stop:(fun () -> true) all));
  let asked = ref 0 in
  let stop () =
    incr asked;
    !asked > 50
  in
  Alcotest.(check bool) "halfway" true (Option.is_none (found ~stop all))

let suite =
  ( "measure",
    [
      Law.example "a subset of all pixels is the picture" same;
      Law.example "pixels are those of the whole picture" subset;
      Law.example "they do not depend on domains" parallel;
      Law.example "what was stopped says nothing" stopped;
    ] )
