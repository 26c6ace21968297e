open Candor_image
open Support

let number = Alcotest.float 1e-12
let linear numbers = Picture_file.Linear (picture_of ~width:1 ~height:1 numbers)

let display maxval samples =
  Picture_file.Display (raster_of ~width:1 ~height:1 ~maxval samples)

let compare a b =
  match Comparison.v a b with Ok c -> c | Error e -> Alcotest.fail e

let check name (c : Comparison.t) ~rmse ~mae ~max ~rel_mse =
  Alcotest.check number (name ^ ": rmse") rmse c.rmse;
  Alcotest.check number (name ^ ": mae") mae c.mae;
  Alcotest.check number (name ^ ": max") max c.max;
  Alcotest.check number (name ^ ": rel_mse") rel_mse c.rel_mse

let by_hand () =
  check "linear"
    (compare (linear [| 1.; 2.; 0. |]) (linear [| 1.; 4.; -1. |]))
    ~rmse:(sqrt (5. /. 3.))
    ~mae:1. ~max:2.
    ~rel_mse:(((4. /. 16.001) +. (1. /. 1.001)) /. 3.);
  check "8-bit, in units of 1/255"
    (compare (display 255 [| 10; 0; 255 |]) (display 255 [| 13; 0; 251 |]))
    ~rmse:(5. /. sqrt 3.)
    ~mae:(7. /. 3.) ~max:4.
    ~rel_mse:
      (((9. /. ((13. *. 13.) +. 65.025)) +. (16. /. ((251. *. 251.) +. 65.025)))
      /. 3.)

let depths () =
  check "16-bit against 8-bit"
    (compare (display 65535 [| 257; 0; 65535 |]) (display 255 [| 1; 0; 255 |]))
    ~rmse:0. ~mae:0. ~max:0. ~rel_mse:0.

let rejects expected a b =
  match Comparison.v a b with
  | Ok _ -> Alcotest.fail "accepted"
  | Error message -> Alcotest.(check string) "message" expected message

let mismatches () =
  let wide =
    Picture_file.Linear (picture_of ~width:2 ~height:1 (Array.make 6 0.))
  in
  let one = linear [| 0.; 0.; 0. |] in
  rejects "the pictures differ in size: 2x1 and 1x1" wide one;
  let message =
    "one picture is linear (PFM) and the other is not (PPM or PNG): write both \
     in the same kind of format"
  in
  rejects message one (display 255 [| 0; 0; 0 |]);
  rejects message (display 255 [| 0; 0; 0 |]) one

let non_finite () =
  let all name x a b =
    let c = compare (linear a) (linear b) in
    check name c ~rmse:x ~mae:x ~max:x ~rel_mse:x;
    Alcotest.(check int) (name ^ ": counted") 1 c.non_finite
  in
  let odd = [| infinity; neg_infinity; nan |] in
  all "the same on both sides" 0. odd odd;
  all "infinite in a" infinity [| infinity; 0.; 0. |] [| 1.; 0.; 0. |];
  all "infinite in b" infinity [| 1.; 0.; 0. |] [| infinity; 0.; 0. |];
  all "opposite infinities" infinity [| infinity; 0.; 0. |]
    [| neg_infinity; 0.; 0. |];
  all "nan in a" nan [| nan; 0.; 5. |] [| 1.; 0.; 0. |];
  all "nan in b" nan [| 1.; 0.; 5. |] [| nan; 0.; 0. |];
  all "nan beside infinity" nan [| infinity; 0.; nan |] [| 0.; 0.; 0. |]

let thresholds () =
  let within e a b = Comparison.within e (compare (linear a) (linear b)) in
  let check name expected got = Alcotest.(check bool) name expected got in
  check "equal" true (within 1. [| 1.; 1.; 1. |] [| 0.; 0.; 0. |]);
  check "above" false (within 0.9 [| 1.; 1.; 1. |] [| 0.; 0.; 0. |]);
  check "nan" false (within infinity [| nan; 1.; 1. |] [| 0.; 0.; 0. |])

let json () =
  Alcotest.(check string)
    "finite"
    {|{"width":1,"height":1,"unit":"1/255","rmse":1,"mae":1,"max":1,"rel_mse":0.0151447,"non_finite":0}|}
    (Comparison.to_json
       {
         (compare (display 255 [| 1; 1; 1 |]) (display 255 [| 0; 0; 0 |])) with
         rel_mse = 0.0151447;
       });
  Alcotest.(check string)
    "with more"
    {|{"width":1,"height":1,"unit":"linear","rmse":0,"mae":0,"max":0,"rel_mse":0,"non_finite":0,"flip":0.25,"ppd":null}|}
    (Comparison.to_json
       ~also:[ ("flip", 0.25); ("ppd", nan) ]
       (compare (linear [| 1.; 1.; 1. |]) (linear [| 1.; 1.; 1. |])));
  Alcotest.(check string)
    "not finite"
    {|{"width":1,"height":1,"unit":"linear","rmse":null,"mae":null,"max":null,"rel_mse":null,"non_finite":1}|}
    (Comparison.to_json
       (compare (linear [| nan; 1.; infinity |]) (linear [| 0.; 0.; 0. |])))

let text () =
  Alcotest.(check string)
    "text"
    "size       1x1\n\
     rmse       2 (1/255)\n\
     mae        2 (1/255)\n\
     max        2 (1/255)\n\
     rel mse    0.0615148\n\
     non-finite 0 pixels\n"
    (Comparison.to_text
       (compare (display 255 [| 2; 2; 2 |]) (display 255 [| 0; 0; 0 |])))

let pair =
  let open QCheck2.Gen in
  let* width = side in
  let* height = side in
  let half =
    map
      (picture_of ~width ~height)
      (array_size (pure (3 * width * height)) (float_range 0. 4.))
  in
  pair half half

let ordered (a, b) =
  let c = compare (Linear a) (Linear b) in
  c.mae <= c.rmse *. (1. +. (epsilon_float *. 8.))
  && c.rmse <= c.max *. (1. +. (epsilon_float *. 8.))

let symmetric (a, b) =
  let c = compare (Linear a) (Linear b) and d = compare (Linear b) (Linear a) in
  Comparison.equal { c with rel_mse = 0. } { d with rel_mse = 0. }

let nothing p =
  let c = compare (Linear p) (Linear p) in
  c.rmse = 0. && c.mae = 0. && c.max = 0. && c.rel_mse = 0.

let tests =
  [
    unit "the measures are those worked out by hand" by_hand;
    unit "depths are brought to the same unit" depths;
    unit "pictures that cannot be compared are an error" mismatches;
    unit "values that are not finite are never hidden" non_finite;
    unit "a threshold holds up to equality, and never for nan" thresholds;
    unit "JSON has null where a measure is not finite" json;
    unit "text has one measure a line" text;
    law "a picture does not differ from itself, nan and all" picture nothing;
    law "mean absolute <= rms <= maximum" pair ordered;
    law "all but the relative measure are symmetric" pair symmetric;
  ]

let suite = ("comparison", tests)
