open Candor_colour
open Candor_scene
open Candor_effect
open Candor_trace
open Candor_image

type window = { x0 : int; y0 : int; x1 : int; y1 : int }

let full (s : Scene.t) = { x0 = 0; y0 = 0; x1 = s.width; y1 = s.height }

type report = {
  picture : Picture.t;
  window : window;
  seconds : float;
  domains : int;
  tally : Tally.t;
  words : float;
  non_finite_pixel : (int * int) option;
}

type row = {
  pixels : floatarray;
  tally : Tally.t;
  words : float;
  non_finite : (int * int) option;
}

let row pixel window y =
  let width = window.x1 - window.x0 in
  let pixels = Float.Array.create (3 * width) in
  let tally = Tally.make () in
  (* Local mutation: the row is filled here and never again. *)
  let non_finite = ref None in
  let before = Gc.minor_words () in
  for i = 0 to width - 1 do
    let x = window.x0 + i in
    let c = Pixel.radiance pixel tally ~x ~y in
    if Option.is_none !non_finite && not (Rgb.is_finite c) then
      non_finite := Some (x, y);
    Float.Array.set pixels (3 * i) c.r;
    Float.Array.set pixels ((3 * i) + 1) c.g;
    Float.Array.set pixels ((3 * i) + 2) c.b
  done;
  let words = Gc.minor_words () -. before in
  { pixels; tally; words; non_finite = !non_finite }

let report window ~seconds ~domains rows =
  let list = Array.to_list rows in
  {
    picture =
      Picture.of_rows ~width:(window.x1 - window.x0)
        (Array.map (fun r -> r.pixels) rows);
    window;
    seconds;
    domains;
    tally = Tally.sum (List.map (fun r -> r.tally) list);
    words = List.fold_left (fun sum r -> sum +. r.words) 0. list;
    non_finite_pixel = List.find_map (fun r -> r.non_finite) list;
  }

let complete rows =
  if Array.for_all Option.is_some rows then
    Some (Array.of_list (List.filter_map Fun.id (Array.to_list rows)))
  else None

let run ?(domains = Rows.most_domains ()) ?(stop = fun () -> false)
    ?(progress = ignore) ?window pixel scene =
  let window = Option.value window ~default:(full scene) in
  let height = window.y1 - window.y0 in
  let finished = Atomic.make 0 in
  let one i =
    let row = row pixel window (window.y0 + i) in
    let n = 1 + Atomic.fetch_and_add finished 1 in
    progress (float_of_int n /. float_of_int height);
    row
  in
  let clock = Mtime_clock.counter () in
  let rows = Rows.parallel ~domains ~stop height one in
  let seconds = Mtime.Span.to_float_ns (Mtime_clock.count clock) /. 1e9 in
  Option.map (report window ~seconds ~domains) (complete rows)
