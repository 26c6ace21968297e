open Candor_colour
open Candor_sample
open Candor_effect
open Candor_trace

type t = {
  y : int;
  x0 : int;
  sums : floatarray;
  counts : int array;
  known : int array; (* of how many samples [sampling] is *)
  sampling : Sampling.t array;
  history : floatarray array; (* squares after each doubling of four samples *)
  parts : Sampling.t array;
  first : int array; (* samples taken when there were fewer than four *)
  work : int array; (* rays and tests that these took *)
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
    sampling = Array.make width Sampling.unknown;
    history = Array.make Sys.int_size (Float.Array.create 0);
    parts = Array.make Part.count Sampling.none;
    first = Array.make width 0;
    work = Array.make width 0;
    left_out = Float.Array.make (3 * width) 0.;
    tally = Tally.make ();
    words = 0.;
  }

let width row = Array.length row.counts
let total row = Array.fold_left ( + ) 0 row.counts

let effort (row : t) =
  Tally.total_rays row.tally
  + Candor_surface.Effort.tests (Tally.effort row.tally)

(* {1 Samples} *)

(* How often four were doubled. *)
let doublings samples =
  let rec of_fours n k =
    if n = 1 then Some k
    else if n > 1 && n mod 2 = 0 then of_fours (n / 2) (k + 1)
    else None
  in
  if samples mod Sampler.streams = 0 then of_fours (samples / Sampler.streams) 0
  else None

let squares row ~samples i =
  match doublings samples with
  | Some k when Float.Array.length row.history.(k) > 0 ->
      Float.Array.get row.history.(k) i
  | Some _ | None -> nan

let remember row i ~samples x =
  match doublings samples with
  | None -> ()
  | Some k ->
      if Float.Array.length row.history.(k) = 0 then
        row.history.(k) <- Float.Array.make (width row) nan;
      Float.Array.set row.history.(k) i x

let update row =
  for i = 0 to width row - 1 do
    let samples = row.counts.(i) in
    if samples > row.known.(i) then (
      let sampling = Sampling.pixel row.sums (Pixel.slots * i) ~samples in
      row.known.(i) <- samples;
      row.sampling.(i) <- sampling;
      remember row i ~samples (Sampling.squares sampling))
  done

(* Each pixel is taken to what it wants, but not past a doubling. *)
let step pixel row wants =
  let words = Gc.minor_words () in
  for i = 0 to width row - 1 do
    let from = row.counts.(i) in
    let until = Int.max from wants.(i) in
    let until =
      if from < Sampler.streams then until else Int.min until (2 * from)
    in
    let is_first = from < Sampler.streams in
    let before = if is_first then effort row else 0 in
    Pixel.add pixel row.tally ~x:(row.x0 + i) ~y:row.y ~from ~until row.sums
      (Pixel.slots * i);
    if is_first then (
      row.first.(i) <- until;
      row.work.(i) <- row.work.(i) + effort row - before);
    Tally.move_left_out row.tally row.left_out (3 * i);
    row.counts.(i) <- until
  done;
  row.words <- row.words +. (Gc.minor_words () -. words);
  update row

let sum_up row =
  Array.fill row.parts 0 Part.count Sampling.none;
  for i = 0 to width row - 1 do
    let part = Part.of_pixel (row.x0 + i) row.y in
    row.parts.(part) <- Sampling.join row.parts.(part) row.sampling.(i)
  done

let take pixel row want =
  let wants = Array.init (width row) want in
  let rec climb () =
    step pixel row wants;
    if Array.exists2 (fun (want : int) n -> want > n) wants row.counts then
      climb ()
  in
  climb ();
  sum_up row

let work (row : t) i =
  float_of_int row.work.(i) /. float_of_int (Int.max 1 row.first.(i))

let of_part (row : t) part = row.parts.(part)

(* {1 Results} *)

type result = {
  pixels : floatarray;
  counts : int array;
  cut : floatarray;
  parts : Sampling.t array;
  non_finite : (int * int) option;
  tally : Tally.t;
  words : float;
}

let sampling r = Sampling.sum Fun.id r.parts

let set_rgb a i (c : Rgb.t) =
  Float.Array.set a (3 * i) c.r;
  Float.Array.set a ((3 * i) + 1) c.g;
  Float.Array.set a ((3 * i) + 2) c.b

let rgb a i =
  Rgb.v
    (Float.Array.get a (3 * i))
    (Float.Array.get a ((3 * i) + 1))
    (Float.Array.get a ((3 * i) + 2))

let first_non_finite (row : t) pixels =
  let rec from i =
    if i = width row then None
    else if Rgb.is_finite (rgb pixels i) then from (i + 1)
    else Some (row.x0 + i, row.y)
  in
  from 0

let result (row : t) =
  let pixels = Float.Array.create (3 * width row) in
  for i = 0 to width row - 1 do
    let samples = row.counts.(i) in
    set_rgb pixels i
      (if samples = 0 then Rgb.black
       else Pixel.mean row.sums (Pixel.slots * i) ~samples)
  done;
  {
    pixels;
    counts = Array.copy row.counts;
    cut =
      Float.Array.mapi
        (fun i w -> w /. float_of_int (Int.max 1 row.counts.(i / 3)))
        row.left_out;
    parts = Array.copy row.parts;
    non_finite = first_non_finite row pixels;
    tally = row.tally;
    words = row.words;
  }

let merge (row : t) ~is_settled before now =
  let of_pixel i =
    if is_settled (Part.of_pixel (row.x0 + i) row.y) then before else now
  in
  let channels f =
    Float.Array.init
      (3 * width row)
      (fun k -> Float.Array.get (f (of_pixel (k / 3))) k)
  in
  let pixels = channels (fun r -> r.pixels) in
  let of_part part (_ : Sampling.t) =
    (if is_settled part then before else now).parts.(part)
  in
  {
    now with
    pixels;
    counts = Array.init (width row) (fun i -> (of_pixel i).counts.(i));
    cut = channels (fun r -> r.cut);
    parts = Array.mapi of_part now.parts;
    non_finite = first_non_finite row pixels;
  }
