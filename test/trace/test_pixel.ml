open Candor_space
open Candor_colour
open Candor_scene
open Candor_effect
open Candor_trace
open Candor_image
open Candor_oracle
open Candor_scene_made

let scene ?(forms = []) settings =
  Written.scene
    ([
       Written.size 8 6;
       "(camera (orthographic (eye 0 0 5) (look-at 0 0 0) (window 0 8 -6 0)))";
       settings;
     ]
    @ forms)

(* The camera's window makes (x, -y) of a ray the place in the picture. *)
let place pixel ~x ~y ~sample =
  let { Ray.origin; _ } = Pixel.ray pixel ~x ~y ~sample in
  (origin.x, -.origin.y)

let centre () =
  let p = Pixel.compile (scene Written.plain) in
  let at x y = place p ~x ~y ~sample:0 in
  let pair = Alcotest.(pair (float 0.) (float 0.)) in
  Alcotest.check pair "pixel 0 0" (0.5, 0.5) (at 0 0);
  Alcotest.check pair "pixel 7 5" (7.5, 5.5) (at 7 5)

let within name settings low high =
  let p = Pixel.compile (scene settings) in
  let reached = ref (infinity, neg_infinity) in
  for i = 0 to 47 do
    let x = i mod 8 and y = i / 8 in
    for sample = 0 to 63 do
      let u, v = place p ~x ~y ~sample in
      let u = u -. float_of_int x and v = v -. float_of_int y in
      if Float.min u v < low || Float.max u v > high then
        Alcotest.failf "%s: sample %d of pixel %d %d is at %g %g" name sample x
          y u v;
      let l, h = !reached in
      reached := (Float.min l u, Float.max h u)
    done
  done;
  let l, h = !reached in
  Alcotest.(check bool)
    (name ^ " reaches its ends")
    true
    (l < low +. 0.1 && h > high -. 0.1)

let filters () =
  within "box" "(render (spp 64))" 0. 1.;
  within "tent" "(render (spp 64) (filter tent))" (-0.5) 1.5

let seeds () =
  let rays seed =
    List.init 8 (fun sample ->
        place
          (Pixel.compile
             (scene (Printf.sprintf "(render (spp 8) (seed %d))" seed)))
          ~x:3 ~y:2 ~sample)
  in
  Alcotest.(check bool) "the same again" true (rays 1 = rays 1);
  Alcotest.(check bool) "another seed" true (rays 1 <> rays 2)

let show = Drawn.show

(* Row by row from the end, and every sample by itself. *)
let any_order (s : Scene.t) =
  let pixel = Pixel.compile s and tally = Tally.make () in
  let n = s.width * s.height in
  let backwards =
    List.init n (fun i ->
        let i = n - 1 - i in
        Pixel.radiance pixel tally ~x:(i mod s.width) ~y:(i / s.width))
  in
  let picture = (Shot.v s).picture in
  List.for_all2
    (fun c i ->
      Rgb.equal c (Picture.pixel picture (i mod s.width) (i / s.width)))
    (List.rev backwards) (List.init n Fun.id)

let mean (s : Scene.t) =
  let pixel = Pixel.compile s and tally = Tally.make () in
  let x = s.width / 2 and y = s.height / 2 in
  let n = float_of_int s.settings.spp in
  let samples =
    List.init s.settings.spp (fun sample ->
        Pixel.sample pixel tally ~x ~y ~sample)
  in
  let mean part =
    let add sum c = Exact.(sum + q (part c)) in
    Q.to_float (List.fold_left add Exact.zero samples) /. n
  in
  Rgb.equal
    (Pixel.radiance pixel tally ~x ~y)
    (Rgb.v
       (mean (fun c -> c.Rgb.r))
       (mean (fun c -> c.Rgb.g))
       (mean (fun c -> c.Rgb.b)))

(* {1 Sums of samples} *)

(* A pixel of a scene, and where its range of samples is cut; some cuts are at
   the same place, some at the end. *)
let cut =
  let open QCheck2.Gen in
  let* s = oneof [ Drawn.scene Round; Rich.scene Round ] in
  let* x = int_bound (s.Scene.width - 1) and* y = int_bound (s.height - 1) in
  let* until = int_range 1 40 in
  let+ cuts = list_size (int_bound 4) (int_bound until) in
  (s, (x, y), List.sort Int.compare (until :: cuts))

let print_cut (s, (x, y), cuts) =
  Printf.sprintf "pixel %d %d, cut at %s, of %s" x y
    (String.concat " " (List.map string_of_int cuts))
    (Drawn.show s)

(* After numbers that are not the pixel's. *)
let before = 3
let empty () = Float.Array.make (before + Pixel.slots + 1) 0.

let same_bits a b =
  let bits a = List.map Int64.bits_of_float (Float.Array.to_list a) in
  List.equal Int64.equal (bits a) (bits b)

let in_parts (s, (x, y), cuts) =
  let pixel = Pixel.compile s in
  let fill cuts =
    let sums = empty () and tally = Tally.make () in
    let part from until =
      Pixel.add pixel tally ~x ~y ~from ~until sums before;
      until
    in
    let (_ : int) = List.fold_left part 0 cuts in
    (sums, tally)
  in
  let parts, tally = fill cuts
  and all, tally' = fill [ List.hd (List.rev cuts) ] in
  let asked t = Tally.get t Camera_rays + Tally.get t Spared_samples in
  same_bits parts all && asked tally = asked tally'

(* Of each stream and of all, against the sum of its samples one by one. *)
let exact_sums (s, (x, y), cuts) =
  let until = List.hd (List.rev cuts) in
  let pixel = Pixel.compile s and tally = Tally.make () in
  let sums = empty () in
  Pixel.add pixel tally ~x ~y ~from:0 ~until sums before;
  let sample i = Pixel.sample pixel tally ~x ~y ~sample:i in
  let samples = List.init until (fun i -> (i, sample i)) in
  let total part own =
    let add sum (i, c) = if own i then Exact.(sum + q (part c)) else sum in
    Q.to_float (List.fold_left add Exact.zero samples)
  in
  let part = [| (fun c -> c.Rgb.r); (fun c -> c.g); (fun c -> c.b) |] in
  let streams = Candor_sample.Sampler.streams in
  let of_stream k =
    let stream = k mod streams and channel = k / streams in
    let sum =
      Candor_number.Running_sum.total
        (Pixel.stream_sum sums before ~stream ~channel)
    in
    Float.equal sum (total part.(channel) (fun i -> i mod streams = stream))
  in
  let all part = total part (fun _ -> true) /. float_of_int until in
  Rgb.equal
    (Pixel.mean sums before ~samples:until)
    (Rgb.v (all part.(0)) (all part.(1)) (all part.(2)))
  && List.for_all of_stream (List.init (3 * streams) Fun.id)
  && Float.Array.get sums 0 = 0.
  && Float.Array.get sums (before + Pixel.slots) = 0.

let nothing_to_add () =
  let s =
    scene ~forms:[ "(sphere (center 4 -3 0) (radius 2))" ] Written.plain
  in
  let pixel = Pixel.compile s and tally = Tally.make () in
  let sums = empty () in
  Pixel.add pixel tally ~x:4 ~y:3 ~from:5 ~until:5 sums before;
  Pixel.add pixel tally ~x:4 ~y:3 ~from:5 ~until:3 sums before;
  Alcotest.(check bool) "no sum" true (same_bits sums (empty ()));
  Alcotest.(check int) "no ray" 0 (Tally.get tally Camera_rays)

let parts () =
  let s = scene ~forms:[ "(sphere (center 0 0 0) (radius 1))" ] Written.plain in
  let p = Pixel.compile s in
  Alcotest.(check bool)
    "the plan" true
    (Plan.equal (Pixel.plan p) (Plan.of_scene s));
  Alcotest.(check bool)
    "another plan" true
    (Plan.equal (Pixel.plan (Pixel.compile ~plan:(Plan.all s) s)) (Plan.all s));
  let hit =
    Candor_surface.Surface.nearest (Pixel.surface p)
      (Ray.v (Point.v 0. 0. 5.) (Vec.v 0. 0. (-1.)))
  in
  Alcotest.(check bool) "the surface" true (Option.is_some hit)

(* Every row and column of a ball seen from 1e9 away. *)
let by_math () =
  let s =
    Written.scene
      [
        Written.size 9 9;
        "(camera (orthographic (eye 0 0 1e9) (look-at 0 0 0) (height 2)))";
        Written.plain;
        "(light (directional (direction 1 0 -1) (irradiance 1)))";
        "(sphere (center 0 0 0) (radius 1))";
      ]
  in
  let seen ?math () =
    let pixel = Pixel.compile ?math s and tally = Tally.make () in
    let centre = Pixel.ray pixel ~x:4 ~y:4 ~sample:0 in
    let picture =
      Picture.init ~width:9 ~height:9 (fun x y ->
          Pixel.radiance pixel tally ~x ~y)
    in
    let hit = Candor_surface.Surface.nearest (Pixel.surface pixel) centre in
    let t = Option.map (fun (h : _ Candor_surface.Hit.t) -> h.t) hit in
    (t, Candor_surface.Effort.careful (Tally.effort tally), picture)
  in
  let time = Alcotest.(option (float 0.)) in
  let t, careful, picture = seen () in
  Alcotest.check time "Candor's" (Some 999999999.) t;
  Alcotest.(check bool) "careful at times" true (careful > 0);
  let t, _, again = seen ~math:Stable () in
  Alcotest.check time "the same, asked for" (Some 999999999.) t;
  Alcotest.(check bool) "the same picture" true (Picture.equal picture again);
  let t, careful, naive = seen ~math:Textbook () in
  Alcotest.check time "the textbook's" (Some 1e9) t;
  Alcotest.(check int) "never careful" 0 careful;
  Alcotest.(check bool) "another picture" false (Picture.equal picture naive)

(* A light as bright as doubles go overflows in the sum of two. *)
let non_finite () =
  let light = "(light (directional (direction 0 0 -1) (irradiance 1.7e308)))" in
  let s =
    scene
      ~forms:
        (List.init 8 (fun _ -> light)
        @ [ "(box (min -9 -9 0) (max 9 9 0) (material (matte (color 1))))" ])
      Written.plain
  in
  let pixel = Pixel.compile s and tally = Tally.make () in
  let c = Pixel.radiance pixel tally ~x:2 ~y:2 in
  Alcotest.(check (float 0.)) "nothing hides it" infinity c.r;
  Alcotest.(check int) "counted" 1 (Tally.get tally Non_finite)

let suite =
  ( "pixels",
    [
      Law.example "one sample goes through the pixel's centre" centre;
      Law.example
        "box samples fill the pixel, tent samples one more on each side" filters;
      Law.example "the seed chooses the samples" seeds;
      Law.law ~count:100 ~print:show
        "pixels do not depend on the order of asking" (Drawn.scene Round)
        any_order;
      Law.law ~count:100 ~print:show
        "a pixel is the mean of its samples, their sum rounded once"
        (Drawn.scene Round) mean;
      Law.law ~count:100 ~print:print_cut
        "samples added in parts have the sums of those added at once" cut
        in_parts;
      Law.law ~count:100 ~print:print_cut
        "sums and mean are those of the samples, rounded once" cut exact_sums;
      Law.example "an empty range adds nothing" nothing_to_add;
      Law.example "a compiled scene tells its plan and surface" parts;
      Law.example "surfaces are met by the math asked for, else by Candor's"
        by_math;
      Law.example "radiance that is not finite is counted and kept" non_finite;
    ] )
