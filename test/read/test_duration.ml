open Candor_read
open QCheck2
open Text

let reads text seconds =
  match Duration.of_string text with
  | Ok found -> Alcotest.(check (float 0.)) text seconds found
  | Error why -> Alcotest.failf "%s: %s" text why

let units () =
  reads "20s" 20.;
  reads "1.5m" 90.;
  reads "1h" 3600.;
  reads "3" 3.;
  reads ".5s" 0.5;
  reads "1e3" 1000.;
  reads "0x1p-3m" 7.5;
  reads "5e-324s" 5e-324

let wrong () =
  List.iter
    (fun text ->
      match Duration.of_string text with
      | Ok found -> Alcotest.failf "%S is taken for %g s" text found
      | Error why ->
          Alcotest.(check string)
            text "expected a time above 0, such as 20s or 1.5m" why)
    [
      "0";
      "0s";
      "-0h";
      "-1";
      "-1s";
      "x";
      "";
      "s";
      "m";
      "h";
      "nan";
      "nans";
      "inf";
      "infinitym";
      "1e400";
      "1e400s";
      "1e308h";
      "1e-400";
      "1 s";
      " 1s";
      "1s ";
      "1sm";
      "1ss";
      "1d";
      "1S";
      "1ms";
      "1min";
      "1:30";
      "1h30m";
    ]

(* Any that there is, the least and the greatest among them. *)
let seconds =
  let wide lo hi = Gen.(map (fun e -> 10. ** e) (float_range lo hi)) in
  let odd = [ 5e-324; 0x1p-1022; max_float; 0.1; 1e23; 1. /. 3. ] in
  Gen.(oneof [ wide (-3.) 6.; wide (-300.) 300.; oneof_list odd ])

let round_trip t =
  match Duration.of_string (Duration.to_string t) with
  | Ok t' -> Float.equal t t'
  | Error why -> Test.fail_reportf "%s: %s" (Duration.to_string t) why

let total text =
  match Duration.of_string text with
  | Ok t -> t > 0. && Float.is_finite t
  | Error why -> why <> ""

let junk =
  Gen.(
    oneof
      [
        string_size (int_bound 6);
        string_size
          ~gen:(oneof_list [ '0'; '1'; '.'; 'e'; '-'; 's'; 'm'; 'h' ])
          (int_bound 6);
      ])

let suite =
  ( "duration",
    [
      case "seconds, minutes and hours are read, seconds without a unit" units;
      case "what is not above 0, not finite or no time is refused" wrong;
      law "what is written is read, to the bit" ~print:(Printf.sprintf "%h")
        seconds round_trip;
      law "any text is a time above 0 and finite, or an error"
        ~print:(Printf.sprintf "%S") junk total;
    ] )
