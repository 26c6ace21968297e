open Candor_render
open Candor_trace
open Candor_oracle

let scene = Test_adaptive.noisy ()
let pixel = Pixel.compile scene
let fresh () = Array.init scene.height (Row.make ~x0:0 ~x1:scene.width)
let take rows n = Array.iter (fun row -> Row.take pixel row (fun _ -> n)) rows

let sampled n =
  let rows = fresh () in
  take rows n;
  rows

let nobody = Array.make Part.count false
let but parts = Array.init Part.count (fun part -> not (List.mem part parts))

let judge ?error ?(full = nobody) rows j =
  Jury.judge ~error ~confidence:0.95 ~full rows j

let start = Jury.start (Window.full scene)

let check name ~is_done ~met j =
  Alcotest.(check (pair bool bool))
    name (is_done, met)
    (Jury.is_done j, Jury.all_met j)

let by_error () =
  let rows = sampled 8 in
  check "before" ~is_done:false ~met:false start;
  check "no error is asked for" ~is_done:false ~met:false (judge rows start);
  check "a small one" ~is_done:false ~met:false (judge ~error:1e-3 rows start);
  check "a large one" ~is_done:true ~met:true (judge ~error:200. rows start)

let by_samples () =
  let rows = sampled 8 in
  let some = judge ~error:1e-3 ~full:(but [ 7; 30 ]) rows start in
  check "two are not full" ~is_done:false ~met:false some;
  check "they are, too" ~is_done:true ~met:false
    (judge ~error:1e-3 ~full:(but []) rows some);
  check "they are good enough" ~is_done:true ~met:false
    (judge ~error:200. rows some)

let too_few () =
  let rows = sampled 3 in
  check "an error that nobody knows" ~is_done:true ~met:false
    (judge ~error:200. rows start);
  check "but nobody asks for" ~is_done:false ~met:false (judge rows start)

(* When one part goes on, its judges are asked, and nobody else. *)
let needed () =
  let rows = sampled 4 in
  List.iter
    (fun part ->
      let j = judge ~full:(but [ part ]) rows start in
      let needed = List.filter (Jury.is_needed j) Part.all in
      Alcotest.(check (list int))
        (Printf.sprintf "part %d" part)
        (List.sort Int.compare (part :: Part.judges part))
        needed)
    Part.all

let kept () =
  let rows = sampled 4 in
  let j = judge ~full:(but [ 7; 30 ]) rows start in
  take rows 16;
  let results = Jury.results rows j in
  let check y x n =
    let goes_on = List.mem (Part.of_pixel x y) [ 7; 30 ] in
    Alcotest.(check int)
      (Printf.sprintf "pixel %d %d" x y)
      (if goes_on then 16 else 4)
      n
  in
  Array.iteri (fun y (r : Row.result) -> Array.iteri (check y) r.counts) results;
  let end_ = judge ~full:(but []) rows j in
  take rows 64;
  Alcotest.(check bool)
    "the end is the end" true
    (Array.for_all2
       (fun (a : Row.result) (b : Row.result) ->
         a.counts = b.counts && a.pixels = b.pixels)
       results (Jury.results rows end_))

let together () =
  let window = { Window.x0 = 0; y0 = 0; x1 = 9; y1 = 11 } in
  let rows = Array.init 11 (Row.make ~x0:0 ~x1:9) in
  take rows 4;
  let j = judge ~full:(but [ 7 ]) rows (Jury.start window) in
  check "one is not full" ~is_done:false ~met:false j;
  Alcotest.(check (list int))
    "all are needed" Part.all
    (List.filter (Jury.is_needed j) Part.all);
  check "no pixel is missing there" ~is_done:true ~met:true
    (judge ~error:200. rows j)

let absent () =
  let window = { Window.x0 = 0; y0 = 0; x1 = 11; y1 = 1 } in
  let rows = [| Row.make ~x0:0 ~x1:11 0 |] in
  take rows 8;
  let j = Jury.start window in
  check "the others go on" ~is_done:false ~met:false j;
  check "and are all that there are" ~is_done:true ~met:true
    (judge ~error:200. rows j)

let all () =
  let rows = sampled 8 in
  let rms s = Option.get (Sampling.rms s) in
  let each = Sampling.sum Row.sampling (Array.map Row.result rows) in
  Alcotest.(check (float 1e-9))
    "part by part or row by row" (rms each)
    (rms (Jury.sampling rows))

let suite =
  ( "juries",
    [
      Law.example "an error is met when judges say so" by_error;
      Law.example "parts stop when no more samples are to be had" by_samples;
      Law.example "nor is an error met that nobody knows" too_few;
      Law.example "those are needed who are asked" needed;
      Law.example "parts that stopped stay as they are" kept;
      Law.example "a few pixels are judged together" together;
      Law.example "parts that a window lacks are done" absent;
      Law.example "they say together what the picture says" all;
    ] )
