open Candor_render
open Candor_oracle
open QCheck2

let show { Pace.share; low; high } =
  Printf.sprintf "%h in [%h, %h]" share low high

let ordered p =
  let { Pace.share; low; high } = p in
  (0. <= low && low <= share && share <= high && high <= 1.)
  || Law.fail "%s" (show p)

let is p share low high = p = { Pace.share; low; high }

(* {1 From parts} *)

let seconds = Gen.oneof [ Draw.wide (-9.) 4.; Draw.pick [ 0.; 1.; 0.1; 1e-9 ] ]

(* Of all, of none, and all alike every now and then. *)
let parts =
  let open Gen in
  let* count = oneof [ int_range 1 6; int_range 1 300 ] in
  let* done_ = oneof [ int_bound count; Draw.pick [ 0; count ] ] in
  let* alike = int_bound 2 and* one = seconds in
  let+ some = list_size (pure done_) seconds in
  (count, if alike = 0 then List.map (fun _ -> one) some else some)

let print_parts (count, seconds) =
  Printf.sprintf "%s of %d"
    (String.concat " " (List.map (Printf.sprintf "%h") seconds))
    count

let law name f = Law.law ~print:print_parts name parts f
let of_parts (count, seconds) = Pace.of_parts ~count ~seconds
let in_order case = ordered (of_parts case)

let counted ((count, seconds) as case) =
  (of_parts case).share
  = float_of_int (List.length seconds) /. float_of_int count

let ends (count, seconds) =
  is (of_parts (count, [])) 0. 0. 1.
  && (List.length seconds < count || is (of_parts (count, seconds)) 1. 1. 1.)

(* A minute or an hour, what is left of it is the same share. *)
let any_unit (count, seconds) =
  let p = of_parts (count, seconds)
  and q = of_parts (count, List.map (Float.mul 0x1p12) seconds) in
  p = q

(* Of parts that differ at random, the share of their time that is spent is
   within the bounds as often as they say. *)
let coverage () =
  let rand = Random.State.make [| 5 |] in
  let count = 200 and spent = 40 and trials = 1000 in
  let trial () =
    let all = List.init count (fun _ -> -.log (Random.State.float rand 1.)) in
    let sum = List.fold_left ( +. ) 0. in
    let seconds = List.filteri (fun i _ -> i < spent) all in
    let { Pace.low; high; _ } = Pace.of_parts ~count ~seconds in
    let truth = sum seconds /. sum all in
    low <= truth && truth <= high
  in
  let hits = List.length (List.filter trial (List.init trials (fun _ -> ()))) in
  let share = float_of_int hits /. float_of_int trials in
  if not (0.9 <= share && share <= 0.98) then
    Alcotest.failf "%.3f of them, not about .95" share

(* {1 From forecasts} *)

let forecast =
  let open Gen in
  let+ a = Draw.wide 0. 9.
  and+ b = Draw.wide 0. 9.
  and+ c = Draw.wide 0. 9.
  and+ taken = oneof [ Draw.wide 0. 10.; Draw.pick [ 0. ] ] in
  match List.sort Float.compare [ a; b; c ] with
  | [ low; total; high ] -> (taken, { Forecast.taken; low; total; high })
  | _ -> (taken, { Forecast.taken; low = a; total = a; high = a })

let print_forecast (taken, { Forecast.low; total; high; _ }) =
  Printf.sprintf "%h of %h in [%h, %h]" taken total low high

let of_forecast (taken, f) =
  let p = Pace.of_forecast ~taken f in
  ordered p
  && (taken > 0. || is p 0. 0. 0.)
  && (taken < f.Forecast.high || is p 1. 1. 1.)
  && (taken > f.low || Float.equal p.share (taken /. f.total))

let without_end () =
  let f =
    { Forecast.taken = 5.; low = 5.; total = infinity; high = infinity }
  in
  Alcotest.(check bool)
    "nothing is known" true
    (is (Pace.of_forecast ~taken:5. f) 0. 0. 1.);
  let none = { Forecast.taken = 0.; low = 0.; total = 0.; high = 0. } in
  Alcotest.(check bool)
    "nothing is expected" true
    (ordered (Pace.of_forecast ~taken:0. none))

(* {1 Time} *)

let time () =
  let check name p expected =
    let triple = Alcotest.(triple (float 1e-12) (float 1e-12) (float 1e-12)) in
    Alcotest.check triple name expected (Pace.time_left p ~elapsed:60.)
  in
  check "half" (Pace.sure 0.5) (60., 60., 60.);
  check "done" (Pace.sure 1.) (0., 0., 0.);
  check "not begun" (Pace.sure 0.) (infinity, infinity, infinity);
  check "from where to where"
    { share = 0.5; low = 0.25; high = 0.75 }
    (60., 20., 180.)

let suite =
  ( "paces",
    [
      law "of parts, low <= share <= high, in [0, 1]" in_order;
      law "the share is that of the parts" counted;
      law "nothing is known at the start, all at the end" ends;
      law "seconds times 2^k leave the share" any_unit;
      Law.example "the bounds hold the share of time 95 times of 100" coverage;
      Law.law ~print:print_forecast
        "of a forecast they are those of samples, exact at the ends" forecast
        of_forecast;
      Law.example "a forecast without an end says nothing" without_end;
      Law.example "the time left goes by the share, and its bounds" time;
    ] )
