open Candor_render
open Candor_oracle
open QCheck2

let string =
  let awkward =
    Gen.oneof
      [
        Gen.char;
        Gen.printable;
        Draw.pick [ '"'; '\\'; '\n'; '\000'; '\127'; '\031'; '/' ];
      ]
  in
  Gen.oneof
    [
      Gen.string_size ~gen:awkward (Gen.int_bound 12);
      Draw.pick [ "grün"; "\u{1F600}"; "\xff\xfe"; "\u{2028}" ];
    ]

let float =
  Gen.oneof
    [
      Draw.coordinate;
      Draw.pick
        [ nan; infinity; neg_infinity; 1e22; 1e300; -0.; 0.1; 1e-7; max_float ];
    ]

let rec json depth : Json.t Gen.t =
  let open Gen in
  let leaf =
    oneof
      [
        pure Json.Null;
        map (fun b -> Json.Bool b) bool;
        map (fun n -> Json.Int n) (oneof [ int; int_range (-9) 9 ]);
        map (fun x -> Json.Float x) float;
        map (fun s -> Json.String s) string;
      ]
  in
  if depth = 0 then leaf
  else
    let below = json (depth - 1) in
    oneof
      [
        leaf;
        map (fun l -> Json.List l) (list_size (int_bound 4) below);
        map
          (fun l -> Json.Object l)
          (list_size (int_bound 4) (pair string below));
      ]

(* Bytes that are no UTF-8 become question marks. *)
let shown s =
  if String.is_valid_utf_8 s then s
  else String.map (fun c -> if Char.code c < 0x80 then c else '?') s

let all2 f a b = List.compare_lengths a b = 0 && List.for_all2 f a b

let rec same (j : Json.t) (r : Json_reader.t) =
  match (j, r) with
  | Null, Null -> true
  | Bool a, Bool b -> a = b
  | Int n, Number s -> s = string_of_int n
  | Float x, Null -> not (Float.is_finite x)
  | Float x, Number s -> Float.is_finite x && Float.equal (float_of_string s) x
  | String a, String b -> String.equal (shown a) b
  | List a, List b -> all2 same a b
  | Object a, Object b ->
      all2 (fun (n, v) (m, w) -> shown n = m && same v w) a b
  | (Null | Bool _ | Int _ | Float _ | String _ | List _ | Object _), _ -> false

let round_trip j =
  let text = Json.to_string j in
  match Json_reader.read text with
  | Ok r -> same j r && String.ends_with ~suffix:"\n" text
  | Error at -> Law.fail "not JSON from byte %d on" at

let golden () =
  Alcotest.(check string)
    "indented"
    "{\n\
    \  \"a\": [\n\
    \    1,\n\
    \    null,\n\
    \    0.5\n\
    \  ],\n\
    \  \"b\\\"\\n\": {},\n\
    \  \"c\": []\n\
     }\n"
    (Json.to_string
       (Object
          [
            ("a", List [ Int 1; Float nan; Float 0.5 ]);
            ("b\"\n", Object []);
            ("c", List []);
          ]))

let odd () =
  let check expected j =
    Alcotest.(check string) expected (expected ^ "\n") (Json.to_string j)
  in
  check "null" (Float infinity);
  check "null" (Float neg_infinity);
  check "\"\\u0000\\u001f\\n\\\\\\\"\"" (String "\000\031\n\\\"");
  check "\"gr\u{fc}n\"" (String "gr\u{fc}n");
  check "\"a??b\"" (String "a\xff\xfeb")

(* The reader here must not be too kind. *)
let strict () =
  List.iter
    (fun text ->
      match Json_reader.read text with
      | Ok _ -> Alcotest.failf "taken for JSON: %s" text
      | Error _ -> ())
    [
      "";
      "nan";
      "inf";
      "1.";
      ".5";
      "01";
      "+1";
      "0x1";
      "[1,]";
      "{\"a\":1,}";
      "\"\n\"";
      "\"\\x\"";
      "1 2";
      "{a:1}";
      "[1";
      "\"\xff\"";
    ]

let suite =
  ( "JSON",
    [
      Law.example "a golden text" golden;
      Law.example "escapes, and numbers that JSON cannot write" odd;
      Law.example "the reader in this test is strict" strict;
      Law.law ~count:1000 ~print:Json.to_string
        "an independent reader reads what was written" (json 3) round_trip;
    ] )
