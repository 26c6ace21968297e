open Candor_image
open Candor_render
open Candor_trace
open Candor_oracle
open Candor_scene_made
open QCheck2

(* A soft shadow on a wall, half lit: noise on one side, none above. *)
let noisy ?(size = (16, 12)) ?(seed = 0) () =
  Written.scene
    [
      Written.size (fst size) (snd size);
      Printf.sprintf "(render (seed %d))" seed;
      Written.flat_camera;
      "(background .2)";
      "(box (min -2 -1 -1) (max 2 .5 0) (material (matte (color .8))))";
      "(box (min -.3 -.9 .5) (max .3 .2 .6) (material (matte (color .8))))";
      "(sphere (center -2 2 3) (radius .7) (material (emitter (radiance 9))))";
    ]

let flat =
  Written.scene [ Written.size 6 5; Written.flat_camera; "(background .3)" ]

let target ?error ?(confidence = 0.95) ?left ?(most = 1 lsl 20) () =
  { Adaptive.error; confidence; left; most }

let render ?(domains = 2) ?progress ?window samples s =
  match Render.run ~domains ?progress ?window ~samples (Pixel.compile s) s with
  | Some r -> r
  | None -> Alcotest.fail "the render was stopped"

let adaptive ?domains ?progress ?window target s =
  render ?domains ?progress ?window (Adaptive target) s

let aim (r : Render.report) =
  match r.aim with
  | Some aim -> aim
  | None -> Alcotest.fail "an adaptive render tells how it went"

let endings =
  Alcotest.testable
    (Fmt.of_to_string (function
      | Adaptive.Met -> "met"
      | Misjudged -> "misjudged"
      | Out_of_time -> "out of time"
      | Out_of_samples -> "out of samples"))
    ( = )

let ends name expected r = Alcotest.check endings name expected (aim r).ending

let upper ?(confidence = 0.95) (r : Render.report) =
  Sampling.upper ~confidence r.sampling

let map (r : Render.report) = Sample_map.to_string r.map

(* {1 Forecasts} *)

let in_order taken (f : Forecast.t) =
  let { Forecast.taken = now; total; low; high } = f in
  if not (taken <= now && now <= low && low <= total && total <= high) then
    Alcotest.failf "%g taken (%g before), %g in %g .. %g" now taken total low
      high;
  now

let forecasts r = ignore (List.fold_left in_order 0. (aim r).forecasts : float)

(* {1 Endings} *)

(* The ledger's word and its number agree, and most such renders are good. *)
let met () =
  let is_met ~error ~confidence seed =
    let s = noisy ~size:(32, 24) ~seed () in
    let r = adaptive (target ~error ~confidence ()) s in
    forecasts r;
    (match Sampling.interval ~confidence:0.99 r.sampling with
    | Some { low; _ } when low <= error -> ()
    | Some { low; _ } -> Alcotest.failf "seed %d: %g at least" seed low
    | None -> Alcotest.failf "seed %d: unknown" seed);
    match ((aim r).ending, Sampling.rms r.sampling) with
    | Met, Some rms when rms <= error -> true
    | Misjudged, Some rms when rms > error -> false
    | _, rms ->
        Alcotest.failf "%g at %g, seed %d: %g" error confidence seed
          (Option.value rms ~default:nan)
  in
  List.iter
    (fun (error, confidence, least) ->
      let seeds = List.init 10 Fun.id in
      let met = List.length (List.filter (is_met ~error ~confidence) seeds) in
      if met < least then
        Alcotest.failf "%g at %g: %d of 10" error confidence met)
    [ (20., 0.5, 5); (6., 0.95, 9); (2., 0.68, 6); (1., 0.99, 9) ]

(* Who asks for little is not told off for getting it. *)
let unsure () =
  let target = target ~error:3. ~confidence:0.1 () in
  let is_met seed =
    let r = adaptive target (noisy ~size:(32, 24) ~seed ()) in
    (aim r).ending = Met
    && Option.fold ~none:false
         ~some:(fun rms -> rms > 3.)
         (Sampling.rms r.sampling)
  in
  let met = List.length (List.filter is_met (List.init 10 Fun.id)) in
  if met < 3 then Alcotest.failf "%d of 10" met

(* Uneven noise is worth uneven numbers. *)
let uneven () =
  let r = adaptive (target ~error:1. ()) (noisy ()) in
  let least = Sample_map.least r.map and most = Sample_map.most r.map in
  if most < 3 * least then
    Alcotest.failf "from %d to %d samples only" least most

let all_alike () =
  let r = adaptive (target ~error:0.001 ()) flat in
  ends "no error" Met r;
  Alcotest.(check (option (float 0.))) "none at all" (Some 0.) (upper r);
  Alcotest.(check int) "four samples tell that" 4 (Sample_map.most r.map)

let out_of_samples () =
  List.iter
    (fun most ->
      let r = adaptive (target ~error:0.01 ~most ()) (noisy ()) in
      let name = Printf.sprintf "%d at most" most in
      ends name Out_of_samples r;
      forecasts r;
      Alcotest.(check int) name most (Sample_map.most r.map))
    [ 1; 2; 3; 4; 5; 8; 30 ]

(* A clock of its own: each look at it takes a while. *)
let clock ~seconds ~step =
  let looks = Atomic.make 0 in
  let left () =
    let n = Atomic.fetch_and_add looks 1 in
    if n > 10_000 then Alcotest.fail "it never ends";
    seconds -. (step *. float_of_int n)
  in
  (looks, left)

let out_of_time () =
  List.iter
    (fun (error, seconds, step) ->
      let looks, left = clock ~seconds ~step in
      let r = adaptive (target ?error ~left ~most:1024 ()) (noisy ()) in
      let name = Printf.sprintf "%g s by %g" seconds step in
      ends name Out_of_time r;
      forecasts r;
      Alcotest.(check bool)
        (name ^ ": some pixel has a sample")
        true
        (Sample_map.most r.map >= 1);
      Alcotest.(check bool)
        (name ^ ": not many looks")
        true
        (Atomic.get looks < 1000))
    [
      (None, 10., 1.);
      (None, 10., 0.3);
      (None, 0., 0.);
      (None, -5., 1.);
      (Some 0.001, 10., 3.);
      (Some 0.001, 1e-9, 1e-9);
    ]

let either_first () =
  let _, left = clock ~seconds:1e6 ~step:1e-3 in
  ends "the error" Met (adaptive (target ~error:5. ~left ()) (noisy ()));
  let _, left = clock ~seconds:10. ~step:1. in
  ends "the time" Out_of_time
    (adaptive (target ~error:0.01 ~left ()) (noisy ()))

(* What has no error needs no time. *)
let nothing_to_spend () =
  let r = adaptive (target ~left:(fun () -> 1e6) ()) flat in
  Alcotest.(check bool) "few" true (Sample_map.most r.map <= 16)

(* The wall clock, which the samples of a picture wear away. *)
let spends () =
  let seconds = 0.5 in
  let start = Unix.gettimeofday () in
  let left () = start +. seconds -. Unix.gettimeofday () in
  let r = adaptive ~domains:1 (target ~left ()) (noisy ()) in
  let spent = Unix.gettimeofday () -. start in
  ends "the time is up" Out_of_time r;
  forecasts r;
  if not (0.4 <= spent && spent <= 2.) then
    Alcotest.failf "%g s instead of %g" spent seconds

(* {2 A clock of work}

   What is noisy takes many times what the background does. *)

let glass =
  lazy
    (Written.scene
       [
         Written.size 48 36;
         Written.flat_camera;
         "(background .2)";
         "(indirect-light)";
         "(box (min -.5 -.5 -1) (max .5 .5 0) (material (matte (color .8))))";
         "(sphere (center -.2 .2 .4) (radius .3) (material (glass (index \
          1.5))))";
         "(sphere (center -2 2 3) (radius .7) (material (emitter (radiance \
          9))))";
       ])

(* The samples that each pixel has when there was time for what [samples] of each
   take, and the share of that time that was spent. *)
let by_work s samples =
  let pixel = Pixel.compile s in
  let fresh () = Array.init s.height (Row.make ~x0:0 ~x1:s.width) in
  let take rows wanted =
    Array.iteri (fun y row -> Row.take pixel row (fun x -> wanted x y)) rows;
    Some ()
  in
  let effort rows =
    float_of_int (Array.fold_left (fun n r -> n + Row.effort r) 0 rows)
  in
  let once = fresh () and rows = fresh () in
  ignore (take once (fun _ _ -> 1));
  let seconds = samples *. effort once in
  let left () = seconds -. effort rows in
  let target = target ~left () and pass = take rows in
  match Adaptive.run (Window.full s) rows target ~pass ~expect:ignore with
  | None -> Alcotest.fail "nothing stops it"
  | Some { results; _ } ->
      ( Array.map (fun (r : Row.result) -> r.counts) results,
        effort rows /. seconds )

let slow_where_noisy () =
  let _, spent = by_work (Lazy.force glass) 64. in
  if not (0.95 <= spent && spent <= 1.05) then
    Alcotest.failf "%g of the time" spent

(* A wall behind a bar, whose shadow has a rim a few pixels wide; and as wide as
   the picture. *)
let shadow ~radius =
  Written.scene
    [
      Written.size 48 36;
      Written.flat_camera;
      "(background .2)";
      "(box (min -9 -9 -1) (max 9 9 0) (material (matte (color .8))))";
      "(box (min -.2 -9 2) (max .2 9 2.1) (material (matte (color .8))))";
      Printf.sprintf
        "(sphere (center 2 0 6) (radius %g) (material (emitter (radiance %g))))"
        radius
        (4. /. (radius *. radius));
    ]

let for_some () =
  let least s =
    let counts, _ = by_work s 64. in
    let of_row = Array.fold_left Int.min max_int in
    Array.fold_left (fun n row -> Int.min n (of_row row)) max_int counts
  in
  let few = least (shadow ~radius:0.1) and all = least (shadow ~radius:2.) in
  if not (4 <= few && 2 * few <= all && all <= 32) then
    Alcotest.failf "%d for noise in few places, %d everywhere" few all

(* What is left at the end is less than a turn of one part takes. *)
let part_by_part () =
  List.iter
    (fun samples ->
      let counts, spent = by_work (Lazy.force glass) samples in
      let of_part = Array.make Part.count 0 in
      let note y x n = of_part.(Part.turn (Part.of_pixel x y)) <- n in
      Array.iteri (fun y row -> Array.iteri (note y) row) counts;
      let alike y x n = n = of_part.(Part.turn (Part.of_pixel x y)) in
      let all f = Array.for_all Fun.id (Array.mapi f counts) in
      let first = of_part.(0) in
      let falls i n =
        (i = 0 || n <= of_part.(i - 1)) && (n = first || n = first - 1)
      in
      if
        not
          (all (fun y row -> Array.for_all Fun.id (Array.mapi (alike y) row))
          && Array.for_all Fun.id (Array.mapi falls of_part))
      then Alcotest.failf "%g samples each: uneven" samples;
      (* A turn is a 61st of a sample each, give or take what pixels cost; and
         none begins in the last fifth that it would fill. *)
      let turn = 0.02 /. samples in
      let least = 0.97 -. (1.25 *. turn) and most = 1.03 +. turn in
      if not (least <= spent && spent <= most) then
        Alcotest.failf "%g samples each: %g of the time" samples spent)
    [ 0.01; 0.1; 0.5; 0.9; 1.; 1.7; 3.5 ]

(* Where most parts have no pixels, also the one whose turn is first. *)
let small_windows () =
  let s = noisy () in
  List.iter
    (fun (x0, y0, x1, y1) ->
      let window = { Window.x0; y0; x1; y1 } in
      let name = Window.show window in
      let looks, left = clock ~seconds:10. ~step:1. in
      let r = adaptive ~window (target ~left ~most:64 ()) s in
      Alcotest.(check bool) name true (Sample_map.most r.map >= 1);
      if Atomic.get looks > 30 then
        Alcotest.failf "%s: %d looks" name (Atomic.get looks);
      (* As soon as all have what they may have, that is the end. *)
      let _, left = clock ~seconds:1e6 ~step:1e-3 in
      let r = adaptive ~window (target ~left ~most:3 ()) s in
      ends name Out_of_samples r;
      Alcotest.(check int) name 3 (Sample_map.least r.map))
    [
      (0, 0, 1, 1); (5, 3, 6, 4); (15, 11, 16, 12); (3, 2, 8, 3); (7, 0, 8, 12);
    ]

(* {1 The same again} *)

let drawn =
  let open Gen in
  let* s = oneof [ Drawn.scene Round; Rich.scene Round ] in
  let* error = Draw.pick [ 0.5; 2.; 8. ] and* most = Draw.pick [ 4; 20; 70 ] in
  let* x0 = int_bound (s.width - 1) and* y0 = int_bound (s.height - 1) in
  let+ x1 = int_range (x0 + 1) s.width and+ y1 = int_range (y0 + 1) s.height in
  (s, target ~error ~most (), { Window.x0; y0; x1; y1 })

let print (s, (t : Adaptive.target), { Window.x0; y0; x1; y1 }) =
  Printf.sprintf "error %g, %d at most, %d,%d,%d,%d of %s"
    (Option.value t.error ~default:nan)
    t.most x0 y0 x1 y1 (Drawn.show s)

let law name f = Law.law ~count:40 ~print name drawn f

let same (a : Render.report) (b : Render.report) =
  Shot.same a.picture b.picture
  && (map a = map b || Law.fail "%s and\n%s" (map a) (map b))
  && a.sampling = b.sampling

let any_domains (s, target, _) =
  let one = adaptive ~domains:1 target s in
  List.for_all
    (fun domains ->
      let r = adaptive ~domains target s in
      same one r && aim one = aim r)
    [ 2; 5 ]

let repeated (s, target, _) =
  let r = adaptive target s in
  let again = render ~domains:1 (Map r.map) s in
  same r again && again.aim = None

let cropped (s, target, (w : Window.t)) =
  let r = adaptive target s in
  let part = render ~window:w (Map r.map) s in
  let cut =
    Picture.init ~width:(Window.width w) ~height:(Window.height w) (fun x y ->
        Picture.pixel r.picture (w.x0 + x) (w.y0 + y))
  in
  Shot.same cut part.picture
  && List.for_all
       (fun (x, y) -> Sample_map.(samples part.map x y = samples r.map x y))
       (List.concat
          (List.init (Window.height w) (fun y ->
               List.init (Window.width w) (fun x -> (w.x0 + x, w.y0 + y)))))

(* The map of a crop repeats it, too. *)
let of_crop (s, target, (w : Window.t)) =
  let r = adaptive ~window:w target s in
  same r (render ~window:w (Map r.map) s)

let bounded (s, target, _) =
  let r = adaptive target s in
  forecasts r;
  let is_believed =
    match (Sampling.rms r.sampling, target.error) with
    | Some rms, Some error -> rms <= error
    | (Some _ | None), (Some _ | None) -> false
  in
  Sample_map.least r.map >= Int.min 4 target.most
  && Sample_map.most r.map <= target.most
  &&
  match (aim r).ending with
  | Met -> is_believed
  | Misjudged -> not is_believed
  | Out_of_samples ->
      Sample_map.most r.map = target.most || Option.is_some r.non_finite_pixel
  | Out_of_time -> false

(* {1 No bias} *)

(* How many samples pixels have if those of one part are drawn with another
   seed. *)
let counts (s : Candor_scene.Scene.t) target ~part ~seed =
  let { Candor_scene.Scene.width; height; settings; _ } = s in
  let pixel = Pixel.compile s
  and other = Pixel.compile { s with settings = { settings with seed } } in
  let rows = Array.init height (Row.make ~x0:0 ~x1:width) in
  let pass wanted =
    let want is x y = if is (Part.of_pixel x y = part) then wanted x y else 0 in
    let take y row =
      Row.take pixel row (fun x -> want not x y);
      Row.take other row (fun x -> want Fun.id x y)
    in
    Array.iteri take rows;
    Some ()
  in
  match Adaptive.run (Window.full s) rows target ~pass ~expect:ignore with
  | None -> Alcotest.fail "it was stopped"
  | Some { results; _ } -> Array.map (fun (r : Row.result) -> r.counts) results

(* Of many that are alike. *)
let some = List.filter (fun part -> part mod 6 = 0) Part.all

let own part counts =
  Array.mapi
    (fun y -> Array.mapi (fun x n -> if Part.of_pixel x y = part then n else 0))
    counts

let independent target () =
  let s = noisy () in
  List.iter
    (fun part ->
      let counts seed = counts s target ~part ~seed in
      let first = counts 1 in
      let others = List.map counts [ 2; 3; 4; 5; 6 ] in
      let check c =
        Alcotest.(check (array (array int)))
          (Printf.sprintf "part %d" part)
          (own part first) (own part c)
      in
      List.iter check others)
    some

(* All noise is in one pixel: its own part, whose judges see none, stops at once. *)
let lone =
  Written.scene
    [
      Written.size 21 21;
      Written.flat_camera;
      "(sphere (center .01 .02 0) (radius .04) (material (emitter (radiance \
       1))))";
    ]

let misjudged () =
  ends "too large an error" Misjudged (adaptive (target ~error:0.01 ()) lone)

(* Else the law above would say nothing. Some parts have hardly any noise. *)
let dependent () =
  let s = noisy () and target = target ~error:3. () in
  let has_say part =
    let counts seed = counts s target ~part ~seed in
    let first = counts 1 in
    List.exists (fun seed -> counts seed <> first) [ 2; 3; 4 ]
  in
  let parts = List.length (List.filter has_say some) in
  if 2 * parts < List.length some then
    Alcotest.failf "%d parts have a say" parts

let few () =
  let s = noisy () in
  List.iter
    (fun (x1, y1) ->
      let window = { Window.x0 = 7; y0 = 5; x1 = 7 + x1; y1 = 5 + y1 } in
      ends
        (Printf.sprintf "%d by %d" x1 y1)
        Met
        (adaptive ~window (target ~error:4. ()) s))
    [ (1, 1); (2, 1); (1, 2); (2, 2); (5, 1); (9, 7) ]

(* {1 Progress} *)

let told () =
  let seen = Atomic.make [] in
  let rec add (p : Pace.t) =
    let before = Atomic.get seen in
    if not (Atomic.compare_and_set seen before (p :: before)) then add p
  in
  let r = adaptive ~progress:add (target ~error:1. ()) (noisy ()) in
  let paces = Atomic.get seen in
  Alcotest.(check bool) "something is told" true (paces <> []);
  Alcotest.(check bool) "forecasts are made" true ((aim r).forecasts <> []);
  List.iter
    (fun { Pace.share; low; high } ->
      Alcotest.(check bool)
        "in order" true
        (0. <= low && low <= share && share <= high && high <= 1.))
    paces

let stopped () =
  let s = noisy () in
  let looks = Atomic.make 0 in
  let stop () = Atomic.fetch_and_add looks 1 > 30 in
  let samples = Render.Adaptive (target ~error:0.01 ()) in
  let r = Render.run ~domains:2 ~stop ~samples (Pixel.compile s) s in
  Alcotest.(check bool) "no picture" true (Option.is_none r)

let suite =
  ( "adaptive renders",
    [
      Law.example "targets are met" met;
      Law.example "nor does less than an even chance make them missed" unsure;
      Law.example "samples go where the noise is" uneven;
      Law.example "a picture without noise is done at once" all_alike;
      Law.example "the most samples are the end, if the error is not met"
        out_of_samples;
      Law.example "so is the time, and some pixel has a sample" out_of_time;
      Law.example "with both, whichever comes first ends it" either_first;
      Law.example "a picture without an error needs no time" nothing_to_spend;
      Law.example "the time is spent" spends;
      Law.example "also if samples where there is noise take longer"
        slow_where_noisy;
      Law.example "all pixels get few if a few pixels need many" for_some;
      Law.example
        "pixels that lie evenly have the samples that there is time for"
        part_by_part;
      Law.example "so it is in windows of few pixels" small_windows;
      law "1, 2 and 5 domains give the same bits, map and forecasts" any_domains;
      law "its map renders the same bits" repeated;
      law "so it does in a crop" cropped;
      law "a crop's own map repeats the crop" of_crop;
      law "from 4 samples to the most; met as far as its pixels know" bounded;
      Law.example "however a part's samples fall, it has as many of them"
        (independent (target ~error:3. ()));
      Law.example "those of others depend on them" dependent;
      Law.example "nor does it have more when samples run out"
        (independent (target ~error:0.5 ~most:40 ()));
      Law.example "a few pixels are judged together" few;
      Law.example "an error that its own part's judges do not see is not met"
        misjudged;
      Law.example "progress is told with its bounds" told;
      Law.example "a stop ends it without a picture" stopped;
    ] )
