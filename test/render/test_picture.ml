open Candor_scene
open Candor_effect
open Candor_trace
open Candor_image
open Candor_render
open Candor_oracle
open Candor_scene_made
open QCheck2

let report ?domains ?stop ?progress ?window s =
  Render.run ?domains ?stop ?progress ?window (Pixel.compile s) s

let get = function
  | Some (r : Render.report) -> r
  | None -> Alcotest.fail "the render was stopped"

let picture ?domains ?window s = (get (report ?domains ?window s)).picture
let scenes = Gen.oneof [ Drawn.scene Round; Rich.scene Round ]
let law ?(count = 40) name f = Law.law ~count ~print:Drawn.show name scenes f
let counts tally = List.map (Tally.get tally) Tally.counters

let any_domains s =
  let one = get (report ~domains:1 s) in
  List.for_all
    (fun domains ->
      let r = get (report ~domains s) in
      Shot.same one.picture r.picture
      && counts one.tally = counts r.tally
      && r.domains = domains)
    [ 1; 2; 5 ]

let as_pixels s =
  let { Shot.picture = p; tally } = Shot.v s in
  let r = get (report ~domains:2 s) in
  Shot.same p r.picture && counts tally = counts r.tally

let with_window =
  let open Gen in
  let* s = scenes in
  let* x0 = int_bound (s.width - 1) and* y0 = int_bound (s.height - 1) in
  let+ x1 = int_range (x0 + 1) s.width and+ y1 = int_range (y0 + 1) s.height in
  (s, { Window.x0; y0; x1; y1 })

let print_window (s, { Window.x0; y0; x1; y1 }) =
  Printf.sprintf "%d,%d,%d,%d of %s" x0 y0 x1 y1 (Drawn.show s)

let crop (s, ({ Window.x0; y0; x1; y1 } as window)) =
  let all = picture ~domains:1 s and r = get (report ~domains:2 ~window s) in
  let cut =
    Picture.init ~width:(x1 - x0) ~height:(y1 - y0) (fun x y ->
        Picture.pixel all (x0 + x) (y0 + y))
  in
  r.window = window && Shot.same cut r.picture
  && Tally.get r.tally Camera_rays + Tally.get r.tally Spared_samples
     = (x1 - x0) * (y1 - y0) * s.Scene.settings.spp

(* A busier picture than the drawn ones. *)
let many =
  Written.scene
    ([
       Written.size 67 41;
       Written.wide_camera;
       "(background (gradient (down .1) (up .9)))";
       "(render (spp 3))";
       "(light (point (at 5 5 5) (intensity 300)))";
       "(material ball (glazed (color (rgb .7 .2 .2)) (mirror .3)))";
       "(box (min -9 -3.2 -9) (max 9 -3 9))";
     ]
    @ List.init 60 (fun i ->
        let a = float_of_int i in
        Printf.sprintf "(sphere (center %h %h %h) (radius .6) (material ball))"
          (3. *. cos a)
          ((a /. 10.) -. 3.)
          (3. *. sin a)))

let schedule () =
  let reference = picture ~domains:1 many in
  List.iter
    (fun domains ->
      match Shot.difference reference (picture ~domains many) with
      | None -> ()
      | Some where -> Alcotest.failf "%d domains: %s" domains where)
    [ 1; 2; 3; 5; 8; 2; 5 ]

let progress () =
  let seen = Atomic.make [] in
  let rec add x =
    let old = Atomic.get seen in
    if not (Atomic.compare_and_set seen old (x :: old)) then add x
  in
  ignore
    (report ~domains:2 ~progress:(fun (p : Pace.t) -> add p.share) many
      : Render.report option);
  let shares = List.sort Float.compare (Atomic.get seen) in
  Alcotest.(check (list (float 0.)))
    "every row once, up to 1"
    (List.init 41 (fun i -> float_of_int (i + 1) /. 41.))
    shares

let stopped () =
  let rows = Atomic.make 0 in
  let stop () = Atomic.get rows >= 5 in
  let r = report ~domains:2 ~stop ~progress:(fun _ -> Atomic.incr rows) many in
  Alcotest.(check bool) "nothing" true (Option.is_none r);
  Alcotest.(check bool) "soon" true (Atomic.get rows < 12);
  (* A stop that comes after the last row is too late. *)
  let last = Atomic.make false in
  let r =
    report ~domains:1
      ~stop:(fun () -> Atomic.get last)
      ~progress:(fun p -> if p.share = 1. then Atomic.set last true)
      many
  in
  Alcotest.(check bool) "done" true (Option.is_some r)

let non_finite () =
  let s =
    Written.scene
      ([
         Written.size 5 4;
         Written.flat_camera;
         Written.plain;
         "(sphere (center 0 0 0) (radius .3) (material (matte (color 1))))";
       ]
      @ List.init 8 (fun _ ->
          "(light (directional (direction 0 0 -1) (irradiance 1.7e308)))"))
  in
  let r = get (report ~domains:2 s) in
  Alcotest.(check (option (pair int int)))
    "the first pixel"
    (Some (2, 1))
    r.non_finite_pixel;
  Alcotest.(check int) "how many" 2 (Tally.get r.tally Non_finite);
  let r = get (report ~window:{ x0 = 2; y0 = 2; x1 = 4; y1 = 3 } s) in
  Alcotest.(check (option (pair int int)))
    "counted in the full picture"
    (Some (2, 2))
    r.non_finite_pixel;
  Alcotest.(check (option (pair int int)))
    "none elsewhere" None (get (report many)).non_finite_pixel

let measures () =
  let r = get (report ~domains:1 many) in
  Alcotest.(check bool) "seconds" true (r.seconds > 0. && r.seconds < 60.);
  Alcotest.(check bool) "words" true (r.words > 0.);
  Alcotest.(check bool)
    "the full window" true
    (Window.full many = { x0 = 0; y0 = 0; x1 = 67; y1 = 41 }
    && r.window = Window.full many)

let suite =
  ( "renders",
    [
      law "1, 2 and 5 domains give the same bits and counts" any_domains;
      Law.example "a picture is the same however its rows are shared out"
        schedule;
      law "a picture is its pixels" as_pixels;
      Law.law ~count:100 ~print:print_window
        "a crop has the pixels of the full picture" with_window crop;
      Law.example "progress is told after every row" progress;
      Law.example "a stop ends the render without a picture" stopped;
      Law.example "the first pixel that is not finite is named" non_finite;
      Law.example "time, words and window are reported" measures;
    ] )
