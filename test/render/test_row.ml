open Candor_colour
open Candor_effect
open Candor_trace
open Candor_image
open Candor_render
open Candor_oracle
open Candor_scene_made
open QCheck2

let row (s : Candor_scene.Scene.t) y = Row.make ~x0:0 ~x1:s.width y

(* What each pixel is asked for, time after time. *)
let asked =
  let open Gen in
  let* s = oneof [ Drawn.scene Round; Rich.scene Round ] in
  let* y = int_bound (s.height - 1) in
  let+ passes =
    list_size (int_range 1 3) (array_size (pure s.width) (int_bound 6))
  in
  (s, y, passes)

let print (s, y, passes) =
  let pass p = String.concat " " (List.map string_of_int (Array.to_list p)) in
  Printf.sprintf "row %d, %s of %s" y
    (String.concat ", then " (List.map pass passes))
    (Drawn.show s)

let greatest passes i =
  List.fold_left (fun n (p : int array) -> Int.max n p.(i)) 0 passes

let bits a = List.map Int64.bits_of_float (Float.Array.to_list a)

(* One more at the end, so that each pixel has one. *)
let in_passes (s, y, passes) =
  let pixel = Pixel.compile s in
  let some = row s y and once = row s y in
  let want i = 1 + greatest passes i in
  List.iter (fun p -> Row.take pixel some (fun i -> p.(i))) passes;
  let held =
    let { Row.counts; pixels; cut; _ } = Row.result some in
    let is_black a i =
      List.for_all (fun k -> Float.Array.get a ((3 * i) + k) = 0.) [ 0; 1; 2 ]
    in
    List.for_all
      (fun i ->
        counts.(i) = greatest passes i
        && (counts.(i) > 0 || (is_black pixels i && is_black cut i)))
      (List.init s.width Fun.id)
  in
  Row.take pixel some want;
  Row.take pixel some (fun _ -> 0);
  Row.take pixel once want;
  let a = Row.result some and b = Row.result once in
  let camera t = Tally.(get t Camera_rays + get t Spared_samples) in
  held
  && a.counts = Array.init s.width want
  && a.counts = b.counts
  && bits a.pixels = bits b.pixels
  && a.parts = b.parts
  && a.non_finite = b.non_finite
  && camera a.tally = camera b.tally
  && camera a.tally = Array.fold_left ( + ) 0 a.counts

let as_pixels (s, y, _) =
  let picture = Shot.picture s in
  let r = row s y in
  Row.take (Pixel.compile s) r (fun _ -> s.settings.spp);
  let ({ Row.pixels; parts; _ } as result) = Row.result r in
  let at i =
    Rgb.v
      (Float.Array.get pixels (3 * i))
      (Float.Array.get pixels ((3 * i) + 1))
      (Float.Array.get pixels ((3 * i) + 2))
  in
  let all = List.init (Row.width r) Fun.id in
  Row.width r = s.width
  && List.for_all (fun i -> Rgb.equal (at i) (Picture.pixel picture i y)) all
  && List.for_all
       (fun part -> Row.of_part r part = parts.(part))
       (List.init Part.count Fun.id)
  && Row.sampling result = Array.fold_left Sampling.join Sampling.none parts

(* Whatever a pixel went through since, it knows what it showed at each doubling
   of four samples. *)
let remembered (s, y, _) =
  let pixel = Pixel.compile s and all = List.init s.width Fun.id in
  let r = row s y in
  Row.take pixel r (fun _ -> 1);
  Row.take pixel r (fun _ -> 4);
  Row.take pixel r (fun i -> if i mod 2 = 0 then 32 else 9);
  let at_once samples =
    let fresh = row s y in
    Row.take pixel fresh (fun _ -> samples);
    Row.squares fresh ~samples
  in
  let same samples i =
    let a = Row.squares r ~samples i and b = at_once samples i in
    Int64.(equal (bits_of_float a) (bits_of_float b))
    || Law.fail "%d samples of pixel %d: %h and %h" samples i a b
  and unknown samples i = Float.is_nan (Row.squares r ~samples i) in
  List.for_all (fun n -> List.for_all (same n) all) [ 4; 8 ]
  && List.for_all
       (fun i -> i mod 2 = 1 || List.for_all (fun n -> same n i) [ 16; 32 ])
       all
  && List.for_all (fun n -> List.for_all (unknown n) all) [ 1; 3; 9; 12; 64 ]
  && List.for_all (fun i -> i mod 2 = 0 || unknown 16 i) all

let worked (s, y, _) =
  let pixel = Pixel.compile s in
  let r = row s y in
  let count () =
    let t = (Row.result r).tally in
    Tally.total_rays t + Candor_surface.Effort.tests (Tally.effort t)
  in
  Row.take pixel r (fun _ -> 1);
  Row.take pixel r (fun _ -> 4);
  let taken = float_of_int (count ()) in
  Row.take pixel r (fun _ -> 8);
  let sum =
    List.fold_left
      (fun sum i -> sum +. (4. *. Row.work r i))
      0. (List.init s.width Fun.id)
  in
  (sum = taken || Law.fail "%g instead of %g" sum taken)
  && Row.effort r = count ()

(* A result stays as it is while further samples are taken. *)
let kept () =
  let s =
    Written.scene [ Written.size 3 1; Written.flat_camera; "(background .5)" ]
  in
  let pixel = Pixel.compile s and r = row s 0 in
  Row.take pixel r (fun _ -> 1);
  let first = Row.result r in
  let counts = Array.copy first.counts and pixels = bits first.pixels in
  Row.take pixel r (fun i -> 5 + i);
  Alcotest.(check (array int)) "then" counts first.counts;
  Alcotest.(check bool) "its pixels" true (pixels = bits first.pixels);
  Alcotest.(check (array int)) "now" [| 5; 6; 7 |] (Row.result r).counts

(* Even parts as they were after the first pass, odd ones as they are now. *)
let merged (s, y, passes) =
  let pixel = Pixel.compile s and r = row s y in
  Row.take pixel r (fun _ -> 1);
  let before = Row.result r in
  List.iter (fun p -> Row.take pixel r (fun i -> p.(i))) passes;
  let now = Row.result r in
  let is_settled part = part mod 2 = 0 in
  let merged = Row.merge r ~is_settled before now in
  let source part = if is_settled part then before else now in
  let as_source i =
    let source = source (Part.of_pixel i y) in
    let same of_result k =
      Float.equal
        (Float.Array.get (of_result merged) k)
        (Float.Array.get (of_result source) k)
    in
    merged.counts.(i) = source.counts.(i)
    && List.for_all
         (fun k ->
           same (fun (r : Row.result) -> r.pixels) k
           && same (fun (r : Row.result) -> r.cut) k)
         [ 3 * i; (3 * i) + 1; (3 * i) + 2 ]
  in
  List.for_all as_source (List.init s.width Fun.id)
  && List.for_all
       (fun part -> merged.parts.(part) = (source part).parts.(part))
       Part.all
  && merged.tally == now.tally && merged.words = now.words

let suite =
  ( "rows",
    [
      Law.law ~count:100 ~print
        "samples taken in passes are those taken at once" asked in_passes;
      Law.law ~count:100 ~print "a row is its pixels" asked as_pixels;
      Law.law ~count:50 ~print "what each doubling showed is remembered" asked
        remembered;
      Law.law ~count:50 ~print "work is that of the first four samples" asked
        worked;
      Law.law ~count:100 ~print "settled parts are as they were" asked merged;
      Law.example "what was told stays so" kept;
    ] )
