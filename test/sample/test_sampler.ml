open Candor_sample
open Candor_oracle
open QCheck2

let samplers = Sampler.all
let streams = Sampler.streams
let cell n u = int_of_float (u *. float_of_int n)

let names () =
  let names = List.map Sampler.name samplers in
  Alcotest.(check (list string))
    "their names"
    [ "independent"; "stratified"; "sobol" ]
    names;
  Alcotest.(check int) "at least four streams" 4 (Int.max 4 streams)

(* {1 Keys} *)

let any =
  Gen.(
    triple (Draw.pick samplers)
      (oneof [ int_bound 40; int_bound 0x3fffffff ])
      (oneof [ int_bound 40; int_bound 0x3fffffff ]))

let show (s, a, b) = Printf.sprintf "%s, samples %d and %d" (Sampler.name s) a b

let separate (s, a, b) =
  a mod streams = b mod streams || Sampler.stream s a <> Sampler.stream s b

(* No two samples draw the same numbers. *)
let own_numbers (s, a, b) =
  let numbers i = (Sampler.stream s i, Sampler.index s i) in
  a = b || numbers a <> numbers b

let in_order (s, a, _) =
  match s with
  | Sampler.Independent | Stratified -> Sampler.index s a = 0
  | Sobol ->
      Sampler.index s a = a / streams
      && Sampler.stream s a = Sampler.stream s (a + streams)

(* {1 The film} *)

let pixel =
  let open Gen in
  let+ s = Draw.pick samplers
  and+ spp = oneof [ int_range 2 40; Draw.pick [ 64; 100; 257; 1 lsl 30 ] ]
  and+ x = int_bound 5000
  and+ y = int_bound 5000
  and+ seed = int in
  (s, spp, x, y, seed)

let show_pixel (s, spp, x, y, seed) =
  Printf.sprintf "%s, %d spp, pixel %d %d, seed %d" (Sampler.name s) spp x y
    seed

let centre (s, _, x, y, seed) =
  let { Pattern.u; v } = Sampler.film s ~seed ~spp:1 ~x ~y 0 in
  u = 0.5 && v = 0.5

let in_pixel (s, spp, x, y, seed) =
  let at = Sampler.film s ~seed ~spp ~x ~y in
  let inside { Pattern.u; v } = 0. <= u && u < 1. && 0. <= v && v < 1. in
  List.for_all (fun i -> inside (at i)) (List.init (Int.min spp 40) Fun.id)

(* But for [Stratified], which has to know how many there are. *)
let however_many (s, spp, x, y, seed) =
  let at spp = Sampler.film s ~seed ~spp ~x ~y in
  Sampler.equal s Stratified
  || List.for_all (fun i -> at spp i = at 2 i) (List.init 8 Fun.id)

let all_different cells =
  List.length (List.sort_uniq compare cells) = List.length cells

(* Each stream by itself is a net: of its first 2^k points, each box of any
   grid of 2^k boxes holds one. *)
let nets (_, _, x, y, seed) =
  let at = Sampler.film Sobol ~seed ~spp:256 ~x ~y in
  let is_net stream k =
    let points = List.init (1 lsl k) (fun i -> at ((i * streams) + stream)) in
    List.for_all
      (fun a ->
        all_different
          (List.map
             (fun { Pattern.u; v } ->
               (cell (1 lsl a) u, cell (1 lsl (k - a)) v))
             points))
      (List.init (k + 1) Fun.id)
  in
  List.for_all
    (fun stream -> List.for_all (is_net stream) [ 1; 2; 4; 6 ])
    (List.init streams Fun.id)

(* The rows of a pixel, shared out among the samples of one stream. *)
let strata (_, spp, x, y, seed) =
  let spp = Int.min spp 257 in
  let each = (spp + streams - 1) / streams in
  let at = Sampler.film Stratified ~seed ~spp ~x ~y in
  List.for_all
    (fun stream ->
      let own = List.filter (fun i -> i mod streams = stream) in
      let row i = cell each (at i).Pattern.v in
      all_different (List.map row (own (List.init spp Fun.id))))
    (List.init streams Fun.id)

(* {1 Over pixels} *)

let pixels = 1 lsl 16
let place n = (n land 255, n lsr 8)

let over_pixels sampler ~spp i =
  let film = Sampler.film sampler ~seed:7 ~spp in
  fun n ->
    let x, y = place n in
    film ~x ~y i

let uniform () =
  List.iter
    (fun sampler ->
      List.iter
        (fun i ->
          let at = over_pixels sampler ~spp:13 i in
          let name what =
            Printf.sprintf "%s: %s of sample %d" (Sampler.name sampler) what i
          in
          let even what bins f =
            Chi_square.(even (name what) (count bins pixels f))
          in
          even "u" 1024 (fun n -> cell 1024 (at n).u);
          even "v" 1024 (fun n -> cell 1024 (at n).v);
          even "the place" 1024 (fun n ->
              (32 * cell 32 (at n).u) + cell 32 (at n).v))
        [ 0; 1; 4; 7; 12 ])
    samplers

(* {1 Streams know nothing of each other} *)

(* A function that is not linear in either coordinate, of mean 0. *)
let value { Pattern.u; v } = Float.exp (u *. v) -. 1.3179021514544038

(* For each pixel, the mean of one stream of its [spp] samples. *)
let stream_means sampler ~spp stream =
  let film = Sampler.film sampler ~seed:3 ~spp in
  let own = List.filter (fun i -> i mod streams = stream) in
  let own = own (List.init spp Fun.id) in
  let n = float_of_int (List.length own) in
  Array.init 20_000 (fun k ->
      let x, y = place k in
      List.fold_left (fun sum i -> sum +. value (film ~x ~y i)) 0. own /. n)

let correlation a b =
  let n = float_of_int (Array.length a) in
  let mean v = Array.fold_left ( +. ) 0. v /. n in
  let product a b =
    let ma = mean a and mb = mean b in
    let sum = ref 0. in
    Array.iter2 (fun x y -> sum := !sum +. ((x -. ma) *. (y -. mb))) a b;
    !sum
  in
  product a b /. sqrt (product a a *. product b b)

(* Of n independent pairs it is normal, with deviation 1/√n. *)
let unrelated () =
  List.iter
    (fun sampler ->
      let means = Array.init streams (stream_means sampler ~spp:22) in
      for i = 0 to streams - 1 do
        for j = i + 1 to streams - 1 do
          let n = float_of_int (Array.length means.(i)) in
          let z = correlation means.(i) means.(j) *. sqrt n in
          if Float.abs z > 5. then
            Alcotest.failf "%s: streams %d and %d: %.1f deviations"
              (Sampler.name sampler) i j z
        done
      done)
    samplers

(* What the test above would say of samples that are stratified together. *)
let related () =
  let pattern = Pattern.make ~seed:3 ~spp:22 in
  let mean stream k =
    let x, y = place k in
    let own =
      List.filter (fun i -> i mod streams = stream) (List.init 22 Fun.id)
    in
    List.fold_left
      (fun sum i -> sum +. value (Pattern.position pattern ~x ~y i))
      0. own
  in
  let means stream = Array.init 20_000 (mean stream) in
  let z = correlation (means 0) (means 1) *. sqrt 20_000. in
  if z > -10. then Alcotest.failf "%.1f deviations only" z

let law ?(count = 500) name f = Law.law ~count ~print:show_pixel name pixel f

let suite =
  ( "samplers",
    [
      Law.example "each has a name" names;
      Law.law ~print:show "samples of different streams have different keys" any
        separate;
      Law.law ~print:show "no two samples have the same numbers" any own_numbers;
      Law.law ~print:show "a Sobol stream takes the points of its key in order"
        any in_order;
      law "the one sample of spp 1 is at the exact centre" centre;
      law "samples are in their pixel" in_pixel;
      law "where a sample is does not depend on how many there are" however_many;
      law ~count:50 "each stream of Sobol points is a net by itself" nets;
      law "each stream of stratified samples shares the rows out" strata;
      Law.example "every sample by itself is uniform over pixels" uniform;
      Law.example "the means of two streams are uncorrelated" unrelated;
      Law.example "those of samples that are stratified together are not"
        related;
    ] )
