(* A price list to draw: its ladder is rendered, for real noise and times; what
   leaving things out does is made up. *)

open Candor_colour
open Candor_scene
open Candor_effect
open Candor_image
open Candor_trace
open Candor_cost

let with_samples spp seed (s : Scene.t) =
  { s with settings = { s.settings with spp; seed } }

let clock = Unix.gettimeofday

(* Its picture, and the seconds that each of its pixels took. *)
let render (s : Scene.t) =
  let pixel = Pixel.compile s and tally = Tally.make () in
  let seconds = Float.Array.make (s.width * s.height) 0. in
  let picture =
    Picture.init ~width:s.width ~height:s.height (fun x y ->
        let start = clock () in
        let c = Pixel.radiance pixel tally ~x ~y in
        Float.Array.set seconds ((y * s.width) + x) (clock () -. start);
        c)
  in
  (picture, seconds)

let squared (a : Rgb.t) (b : Rgb.t) =
  let d f = (Display.encode (f a) -. Display.encode (f b)) ** 2. in
  (d (fun c -> c.Rgb.r) +. d (fun c -> c.g) +. d (fun c -> c.b)) /. 3.

let errors reference picture =
  let width = Picture.width picture in
  Plane.init ~width ~height:(Picture.height picture) (fun i ->
      let x = i mod width and y = i / width in
      sqrt (squared (Picture.pixel picture x y) (Picture.pixel reference x y)))

let numbers p = List.init (Plane.width p * Plane.height p) (Plane.get p)

let mean xs =
  List.fold_left ( +. ) 0. xs /. float_of_int (Int.max 1 (List.length xs))

let place line column : Place.t = { file = "showcase.scene"; line; column }

let others ~spp (base : Price.measure) : Price.row list =
  let row ?(pareto = false) setting time rms loss verdict : Price.row =
    let measure =
      {
        base with
        seconds = base.seconds *. time;
        rms = base.rms *. rms;
        p99 = base.p99 *. rms;
      }
    in
    { setting; spp; measure; loss; pareto; verdict }
  in
  let light name line = Price.Without_light { name; place = place line 3 } in
  let absent effect_ what line =
    Price.Without_effect
      { absent = effect_; reasons = [ Reason.v what (place line 3) ] }
  in
  [
    row (Depth 3) 0.86 1.02 0.02 (Saves 0.14) ~pareto:true;
    row (Cutoff 0.01) 0.97 1. 0. (Saves 0.03);
    row (Sampler Independent) 0.98 1.6 0.51 Needed;
    row (Sampler Stratified) 0.99 1.1 0.12 Needed;
    row (light "area light lamp" 18) 0.71 24. 21.5 Needed;
    row (light "background" 11) 0.93 9. 6.9 Needed;
    row (light "point light" 23) 0.95 1. 0. Paid_for_nothing;
    row (absent Indirect "indirect-light" 12) 0.44 14. 11.2 Needed;
    row (absent Refraction "material ball" 31) 0.78 5. 3.4 Needed;
    row (absent Gloss "material floor" 27) 0.89 2.1 0.9 Needed;
    row (absent Dispersion "material pane" 36) 0.94 1. 0. Paid_for_nothing;
    row Naive_math 0.93 1.3 0.4 (Wrong_pixels 17);
  ]

let law (ladder : Price.row list) : Price.law option =
  let points =
    List.filter (fun (r : Price.row) -> r.measure.rms > 0.) ladder
    |> List.map (fun (r : Price.row) ->
        (log r.measure.seconds, log r.measure.rms))
  in
  let mx = mean (List.map fst points) and my = mean (List.map snd points) in
  let sum f = List.fold_left (fun n p -> n +. f p) 0. points in
  let sxx = sum (fun (x, _) -> (x -. mx) ** 2.) in
  let slope = sum (fun (x, y) -> (x -. mx) *. (y -. my)) /. sxx in
  let off (x, y) = (y -. my -. (slope *. (x -. mx))) ** 2. in
  let scatter = sqrt (sum off /. float_of_int (List.length points)) in
  if sxx > 0. then Some { a = exp (my -. (slope *. mx)); b = -.slope; scatter }
  else None

let predict (law : Price.law) error : Price.prediction =
  let at shift = (law.a *. exp shift /. error) ** (1. /. law.b) in
  let spread = 1.96 *. law.scatter in
  {
    error;
    seconds = at 0.;
    low = at (-.spread);
    high = at spread;
    spp = int_of_float (Float.min 65536. (64. *. at 0.));
  }

let price ?(times = 1.) ?(name = "showcase.scene") ~rungs ~finest (s : Scene.t)
    : Price.t =
  let reference, _ = render (with_samples finest 99 s) in
  let pictures = List.map (fun n -> (n, render (with_samples n 1 s))) rungs in
  let rung (spp, (picture, seconds)) : Price.row * Price.view =
    let error = errors reference picture in
    let all = List.sort Float.compare (numbers error) in
    let measure : Price.measure =
      {
        seconds = times *. Float.Array.fold_left ( +. ) 0. seconds;
        rays_per_pixel = 2.25 *. float_of_int spp;
        rms = sqrt (mean (List.map (fun e -> e *. e) all));
        p99 = List.nth all (99 * List.length all / 100);
      }
    in
    ( {
        setting = Samples spp;
        spp;
        measure;
        loss = 0.;
        pareto = true;
        verdict = Rung;
      },
      { spp; picture; error } )
  in
  let measured = List.map rung pictures in
  let ladder = List.map fst measured in
  let knee = List.nth_opt ladder (List.length ladder / 2) in
  let law = law ladder in
  let _, (_, seconds) = List.nth pictures (List.length pictures - 1) in
  let time =
    Plane.init ~width:s.width ~height:s.height (Float.Array.get seconds)
  in
  let last = (snd (List.hd measured)).error in
  let level = mean (numbers last) in
  {
    scene = name;
    width = 8 * s.width;
    height = 8 * s.height;
    domains = 2;
    pixels = s.width * s.height;
    budget = 20.;
    spent = 18.3;
    ladder;
    knee;
    others =
      Option.fold ~none:[]
        ~some:(fun (k : Price.row) -> others ~spp:k.spp k.measure)
        knee;
    law;
    predictions =
      Option.fold ~none:[]
        ~some:(fun law -> List.map (predict law) [ 4.; 2.; 1.; 0.5 ])
        law;
    views = List.map snd measured;
    time =
      Plane.init ~width:s.width ~height:s.height (fun i ->
          Plane.get time i /. float_of_int finest);
    samples =
      Plane.init ~width:s.width ~height:s.height (fun i ->
          (0.2 +. Plane.get last i) /. (0.2 +. level));
  }
