open Candor_colour
open Candor_effect
open Candor_trace

type t = {
  y : int;
  x0 : int;
  sums : floatarray;
  counts : int array;
  known : int array; (* of how many samples [sampling] is *)
  sampling : Sampling.t array;
  left_out : floatarray; (* what was cut, as in Tally *)
  tally : Tally.t;
  mutable words : float;
}

let make ~x0 ~x1 y =
  let width = x1 - x0 in
  {
    y;
    x0;
    sums = Float.Array.make (Pixel.slots * width) 0.;
    counts = Array.make width 0;
    known = Array.make width 0;
    sampling = Array.make width Sampling.none;
    left_out = Float.Array.make (3 * width) 0.;
    tally = Tally.make ();
    words = 0.;
  }

let width row = Array.length row.counts
let samples row i = row.counts.(i)
let total row = Array.fold_left ( + ) 0 row.counts

let update row =
  for i = 0 to width row - 1 do
    let samples = row.counts.(i) in
    if samples > row.known.(i) then (
      row.known.(i) <- samples;
      row.sampling.(i) <- Sampling.pixel row.sums (Pixel.slots * i) ~samples)
  done

let take pixel row want =
  let before = Gc.minor_words () in
  for i = 0 to width row - 1 do
    let from = row.counts.(i) in
    let until = Int.max from (want i) in
    Pixel.add pixel row.tally ~x:(row.x0 + i) ~y:row.y ~from ~until row.sums
      (Pixel.slots * i);
    Tally.move_left_out row.tally row.left_out (3 * i);
    row.counts.(i) <- until
  done;
  row.words <- row.words +. (Gc.minor_words () -. before);
  update row

let sampling row i = row.sampling.(i)

type result = {
  pixels : floatarray;
  counts : int array;
  cut : floatarray;
  sampling : Sampling.t;
  non_finite : (int * int) option;
  tally : Tally.t;
  words : float;
}

let mean (row : t) i =
  Pixel.mean row.sums (Pixel.slots * i) ~samples:row.counts.(i)

let result (row : t) =
  let width = width row in
  let pixels = Float.Array.create (3 * width) in
  (* Local mutation: filled here and never again. *)
  let known = ref Sampling.none and non_finite = ref None in
  for i = 0 to width - 1 do
    let c = mean row i in
    if Option.is_none !non_finite && not (Rgb.is_finite c) then
      non_finite := Some (row.x0 + i, row.y);
    known := Sampling.join !known (sampling row i);
    Float.Array.set pixels (3 * i) c.r;
    Float.Array.set pixels ((3 * i) + 1) c.g;
    Float.Array.set pixels ((3 * i) + 2) c.b
  done;
  {
    pixels;
    counts = Array.copy row.counts;
    cut =
      Float.Array.mapi
        (fun i w -> w /. float_of_int row.counts.(i / 3))
        row.left_out;
    sampling = !known;
    non_finite = !non_finite;
    tally = row.tally;
    words = row.words;
  }
