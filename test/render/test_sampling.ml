open Candor_colour
open Candor_number
open Candor_sample
open Candor_trace
open Candor_render
open Candor_oracle
open QCheck2

let streams = Sampler.streams
let size ~samples k = (samples - k + streams - 1) / streams

(* A pixel whose stream [k] has the mean [mean k channel]. *)
let planted ~samples mean =
  let sums = Float.Array.make (1 + Pixel.slots) 0. in
  for k = 0 to streams - 1 do
    for channel = 0 to 2 do
      let sum = float_of_int (size ~samples k) *. mean k channel in
      Running_sum.accumulate sums (1 + (6 * k) + (2 * channel)) sum
    done
  done;
  Sampling.pixel sums 1 ~samples

let grey ~samples means = planted ~samples (fun k _ -> means.(k))
let get = function Some x -> x | None -> Alcotest.fail "nothing is known"

(* {1 What its formulas say} *)

(* The squared change of a displayed value when the streams in [out] are left
   out, weighed so that a linear display would show the squared error. *)
let jackknife ~samples means out =
  let n k = float_of_int (size ~samples k) in
  let mean ks =
    let total f = List.fold_left (fun s k -> s +. f k) 0. ks in
    total (fun k -> n k *. means.(k)) /. total n
  in
  let all = List.init streams Fun.id in
  let rest = List.filter (fun k -> not (List.mem k out)) all in
  let w = List.fold_left (fun s k -> s +. n k) 0. out /. float_of_int samples in
  let change = Display.encode (mean rest) -. Display.encode (mean all) in
  (w, (1. -. w) /. w *. (change ** 2.))

(* J and H of one channel. *)
let direct ~samples means =
  let quarter = List.init streams (fun k -> jackknife ~samples means [ k ]) in
  let half =
    List.concat
      (List.init streams (fun a ->
           List.init a (fun b -> jackknife ~samples means [ a; b ])))
  in
  let sum f = List.fold_left (fun s x -> s +. f x) 0. in
  ( sum (fun (w, x) -> w *. x) quarter,
    sum snd half /. float_of_int (List.length half) )

(* What a display shows of it: dark, clamped, below nothing, and alike. *)
let means =
  let open Gen in
  let value =
    oneof
      [
        Draw.uniform 0. 1.;
        Draw.uniform 0.8 1.4;
        Draw.wide (-6.) 0.;
        Draw.pick [ 0.; 1.; 0.5; 2.; -0.1 ];
      ]
  in
  let near = map2 (fun x d -> x +. (0.01 *. d)) value (Draw.uniform 0. 1.) in
  array_size (pure streams) (oneof [ value; near ])

let pixel = Gen.(pair (int_range 4 40) (triple means means means))

let print (samples, (r, g, b)) =
  let show m =
    String.concat " " (List.map (Printf.sprintf "%h") (Array.to_list m))
  in
  Printf.sprintf "%d samples: %s; %s; %s" samples (show r) (show g) (show b)

let of_means (samples, (r, g, b)) =
  planted ~samples (fun k channel ->
      (match channel with 0 -> r | 1 -> g | _ -> b).(k))

let law ?count name f = Law.law ?count ~print name pixel f

(* Relative to it, and to what rounding leaves of a change on the display. *)
let near expected x =
  Float.abs (x -. expected) <= (1e-9 *. Float.abs expected) +. 1e-18
  || Law.fail "%h instead of %h" x expected

let formulas ((samples, (r, g, b)) as case) =
  let s = of_means case in
  let parts = List.map (direct ~samples) [ r; g; b ] in
  let j = List.fold_left (fun s (j, _) -> s +. j) 0. parts
  and h = List.fold_left (fun s (_, h) -> s +. h) 0. parts in
  let mean_square = if h > 0. then j *. sqrt (j /. h) /. 3. else j /. 3. in
  near (if Sampling.squares s = 0. || j > 0. then j else h) (Sampling.squares s)
  &&
  match Sampling.mean_square s with
  | None -> Sampling.squares s = 0. && h > 0.
  | Some found ->
      (h < 1e-9 || near mean_square found)
      && near (sqrt found) (get (Sampling.rms s))

(* Joined pixels are one sum; their order does not matter but for rounding. *)
let joined (a, b) =
  let s = of_means a and t = of_means b in
  let both = Sampling.join s t in
  near (Sampling.squares s +. Sampling.squares t) (Sampling.squares both)
  && both = Sampling.join t s
  && Sampling.join Sampling.none s = s
  && Sampling.join s Sampling.none = s

(* {1 What is not known} *)

let is_unknown s =
  Sampling.mean_square s = None
  && Sampling.rms s = None
  && Sampling.interval ~confidence:0.95 s = None
  && Sampling.upper ~confidence:0.95 s = None

let unknown () =
  let check name s = Alcotest.(check bool) name true (is_unknown s) in
  let fine = grey ~samples:4 [| 0.1; 0.2; 0.3; 0.4 |] in
  Alcotest.(check bool) "four samples tell" false (is_unknown fine);
  check "no pixel" Sampling.none;
  check "a pixel that only leaving out two streams changes"
    (grey ~samples:16 [| 1.5; 1.5; 1.5; 0.3 |]);
  List.iter
    (fun samples ->
      let few = grey ~samples [| 0.1; 0.2; 0.3; 0.4 |] in
      check (Printf.sprintf "%d samples" samples) few;
      check "a pixel with too few, among others" (Sampling.join fine few))
    [ 0; 1; 2; 3 ];
  List.iter
    (fun x ->
      let odd =
        planted ~samples:16 (fun k channel ->
            if k = 2 && channel = 1 then x else 0.5)
      in
      check (string_of_float x) odd;
      check "a pixel that is not finite, among others" (Sampling.join odd fine))
    [ nan; infinity; neg_infinity ]

(* Not even what rounding makes of sums that are not exact. *)
let nothing () =
  List.iter
    (fun samples ->
      List.iter
        (fun x ->
          let s = grey ~samples [| x; x; x; x |] in
          let name = Printf.sprintf "%d samples of %g" samples x in
          let check = Alcotest.(check (float 0.)) name 0. in
          check (Sampling.squares s);
          check (get (Sampling.rms s));
          let { Sampling.low; high } =
            get (Sampling.interval ~confidence:0.99 s)
          in
          check low;
          check high)
        [ 0.; 0.1; 0.3; 1. /. 3.; 0.7; 0.999; 1.; 5.; 1e-300; -0.2; 1e30 ])
    [ 4; 5; 6; 7; 13; 16; 100; 1001 ]

(* {1 Intervals} *)

let confidence = Gen.oneof [ Draw.uniform 0. 1.; Draw.pick [ 0.; 0.5; 0.95 ] ]
let below_one c = Float.min c 0.999999

let widening (case, (c, d)) =
  let s = of_means case in
  QCheck2.assume (Option.is_some (Sampling.rms s));
  let rms = get (Sampling.rms s) in
  let c = below_one (Float.min c d) and d = below_one (Float.max c d) in
  let a = get (Sampling.interval ~confidence:c s)
  and b = get (Sampling.interval ~confidence:d s) in
  let upper c = get (Sampling.upper ~confidence:c s) in
  0. <= b.low && b.low <= a.low && a.low <= rms && rms <= a.high
  && a.high <= b.high
  && upper (0.5 *. c) <= upper (0.5 *. d)
  && upper (0.5 *. c) <= rms
  && rms <= upper (0.5 *. (1. +. c))
  && near a.high (upper (0.5 *. (1. +. c)))

(* {1 Simulated pictures} *)

(* A tenth of the pixels has ten times the noise of the others. *)
type kind = Normal | Skewed

let draw rand kind =
  let u () = 1. -. Random.State.float rand 1. in
  match kind with
  | Normal -> sqrt (-2. *. log (u ())) *. cos (2. *. Float.pi *. u ())
  | Skewed -> -.log (u ()) -. 1.

let average rand kind n =
  let sum = ref 0. in
  for _ = 1 to n do
    sum := !sum +. draw rand kind
  done;
  !sum /. float_of_int n

(* What the samples of a picture say, and its true mean square error. *)
let simulated rand kind ~pixels ~samples ~noise =
  let of_pixel i =
    let mean = 0.05 +. (0.7 *. float_of_int i /. float_of_int pixels) in
    let deviation = mean *. if i mod 10 = 0 then noise else 0.1 *. noise in
    let means =
      Array.init streams (fun k ->
          mean +. (deviation *. average rand kind (size ~samples k)))
    in
    let sum = ref 0. in
    Array.iteri
      (fun k m -> sum := !sum +. (float_of_int (size ~samples k) *. m))
      means;
    let shown = Display.encode (!sum /. float_of_int samples) in
    (grey ~samples means, (shown -. Display.encode mean) ** 2.)
  in
  let add (s, e) i =
    let s', e' = of_pixel i in
    (Sampling.join s s', e +. e')
  in
  let s, e = List.fold_left add (Sampling.none, 0.) (List.init pixels Fun.id) in
  (s, e /. float_of_int pixels)

(* Of [n] numbers, how many standard errors their mean is from 0. *)
let z numbers =
  let n = float_of_int (List.length numbers) in
  let mean = List.fold_left ( +. ) 0. numbers /. n in
  let squares =
    List.fold_left (fun s x -> s +. ((x -. mean) ** 2.)) 0. numbers
  in
  mean /. sqrt (squares /. (n -. 1.) /. n)

let unbiased () =
  let trials = 200 and pixels = 300 in
  List.iter
    (fun (name, kind, samples, noise) ->
      let rand = Random.State.make [| 11; samples |] in
      let differences =
        List.init trials (fun _ ->
            let s, truth = simulated rand kind ~pixels ~samples ~noise in
            get (Sampling.mean_square s) -. truth)
      in
      let z = z differences in
      Printf.printf "%s: %.2f standard errors\n" name z;
      if Float.abs z > 4. then
        Alcotest.failf "%s: %.1f standard errors from the truth" name z)
    [
      ("normal, 4 samples", Normal, 4, 0.1);
      ("normal, 16 samples", Normal, 16, 0.3);
      ("normal, 19 samples", Normal, 19, 0.3);
      ("skewed, 16 samples", Skewed, 16, 0.3);
      ("skewed, 18 samples", Skewed, 18, 0.3);
    ]

let coverage () =
  let trials = 400 and pixels = 1000 in
  let rand = Random.State.make [| 12 |] in
  let pictures =
    List.init trials (fun _ ->
        simulated rand Normal ~pixels ~samples:4 ~noise:0.1)
  in
  let check name confidence holds =
    let successes = List.length (List.filter holds pictures) in
    let p = Binomial.test ~successes trials confidence in
    Printf.printf "%s, %g: %d of %d, p = %.3f\n" name confidence successes
      trials p;
    if p < 0.001 then
      Alcotest.failf "%s %g: only %d of %d" name confidence successes trials
  in
  List.iter
    (fun confidence ->
      check "within" confidence (fun (s, truth) ->
          let { Sampling.low; high } = get (Sampling.interval ~confidence s) in
          low <= sqrt truth && sqrt truth <= high);
      check "below" confidence (fun (s, truth) ->
          sqrt truth <= get (Sampling.upper ~confidence s)))
    [ 0.5; 0.68; 0.95; 0.99 ]

let caution (a, b) =
  let s = Sampling.join (of_means a) (of_means b) in
  match
    (Sampling.cautious ~confidence:0.68 s, Sampling.upper ~confidence:0.68 s)
  with
  | None, None -> true
  | Some bound, Some upper ->
      upper <= bound || Law.fail "%h, %h at most" bound upper
  | (Some _ | None), (Some _ | None) -> false

(* Where much is known, none is needed. *)
let no_caution () =
  (* Two grey pixels whose streams differ in small, linear steps. *)
  let s = grey ~samples:400 [| 0.5; 0.5001; 0.5002; 0.4999 |] in
  let twice s _ = Sampling.join s s in
  let many = List.fold_left twice s (List.init 27 Fun.id) in
  let rms = get (Sampling.rms many) in
  let bound = get (Sampling.cautious ~confidence:0.95 many) in
  if not (rms <= bound && bound <= 1.001 *. rms) then
    Alcotest.failf "%h for %h" bound rms

let suite =
  ( "sampling errors",
    [
      law "of one pixel they are what the jackknife's formulas say" formulas;
      Law.law
        ~print:(fun (a, b) -> print a ^ " and " ^ print b)
        "of several they add up" (Gen.pair pixel pixel) joined;
      Law.example "fewer than four samples, or what is not finite, tell nothing"
        unknown;
      Law.example "samples that are all alike have no error" nothing;
      Law.law
        ~print:(fun (a, (c, d)) -> Printf.sprintf "%s at %h, %h" (print a) c d)
        "intervals hold the estimate, and the more the surer"
        Gen.(pair pixel (pair confidence confidence))
        widening;
      Law.law
        ~print:(fun (a, b) -> print a ^ " and " ^ print b)
        "caution is above the upper bound" (Gen.pair pixel pixel) caution;
      Law.example "where much is known, caution costs nothing" no_caution;
      Law.example "they are right on average, also of skewed samples" unbiased;
      Law.example "intervals hold the error as often as they say" coverage;
    ] )
