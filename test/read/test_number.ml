open Candor_read
open Text

let reads () =
  let check s x =
    Alcotest.(check (result (float 0.) string)) s (Ok x) (Number.of_string s)
  in
  check "2" 2.;
  check ".5" 0.5;
  check "-.5" (-0.5);
  check "1." 1.;
  check "+1" 1.;
  check "1e3" 1000.;
  check "1E-2" 0.01;
  check "0x1.8p3" 12.;
  check "-0X.8P1" (-1.);
  check "1e-999" 0.

let refuses () =
  let check s =
    Alcotest.(check bool) s true (Result.is_error (Number.of_string s))
  in
  List.iter check
    [ ""; "."; "-"; "e3"; "1e"; "1.2.3"; "nan"; "-nan"; "inf"; "+inf" ];
  List.iter check
    [
      "infinity"; "1_000"; " 1"; "1 "; "1,5"; "0x"; "one"; "1e999"; "--1"; "1f";
    ];
  List.iter check [ "nan(0x1)"; "1\n"; "0b11"; "0o17"; "1u"; "\xc2\xbd" ]

let negative_zero () =
  match Number.of_string "-0" with
  | Ok x -> Alcotest.(check bool) "sign" true (Float.sign_bit x)
  | Error why -> Alcotest.fail why

let meant () =
  let check expected s = Alcotest.(check bool) s expected (Number.is_meant s) in
  List.iter (check true) [ "1"; "-"; ".x"; "+5"; "nan"; "inf"; "1.2.3" ];
  List.iter (check false) [ ""; "x"; "normals"; "e3"; "material" ]

let there_and_back =
  law ~count:5000 "what is printed reads as the same double"
    (Draw_scene.gen Draw_scene.bits) (fun x ->
      (not (Float.is_finite x))
      ||
      match Number.of_string (Number.to_string x) with
      | Ok y -> Int64.equal (Int64.bits_of_float x) (Int64.bits_of_float y)
      | Error _ -> false)

let short () =
  let check s x = Alcotest.(check string) s s (Number.to_string x) in
  check "0.1" 0.1;
  check "-0" (-0.);
  check "4.94065645841247e-324" 0x1p-1074;
  check "0.30000000000000004" (0.1 +. 0.2);
  check "640" 640.

let suite =
  ( "number",
    [
      case "decimal and hexadecimal numbers are read" reads;
      case "what is not quite a number is refused" refuses;
      case "zero keeps its sign" negative_zero;
      case "an attempt at a number is seen as one" meant;
      there_and_back;
      case "numbers are printed as short as can be" short;
    ] )
