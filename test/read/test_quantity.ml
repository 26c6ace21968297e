open Candor_read
open Text

let share = Rule.within 0. 1.

let numbers () =
  let v = Quantity.number share (fun () -> "the weight") in
  let check text expected =
    let found, messages = Piece.value v text in
    Alcotest.(check (pair (option (float 0.)) (list string)))
      text expected (found, messages)
  in
  check ".5" (Some 0.5, []);
  check "0x1p-3" (Some 0.125, []);
  check "2" (None, [ "1 the weight must be from 0 to 1, but is `2`" ]);
  check "half" (None, [ "1 `half` is not a number" ]);
  check "(half)" (None, [ "1 expected a number, not (half ...)" ])

let hints () =
  let v = Quantity.number ~hint:"try .5" share (fun () -> "it") in
  let check text expected =
    Alcotest.(check (list string)) text expected (snd (Piece.value v text))
  in
  check "half" [ "1 `half` is not a number; try .5" ];
  check "2" [ "1 it must be from 0 to 1, but is `2`" ]

let floats = Alcotest.(option (array (float 0.)))

let named () =
  let b = Quantity.numbers "X Y" share in
  let check text expected messages =
    let found = Piece.body b text in
    Alcotest.(check (pair floats (list string))) text (expected, messages) found
  in
  check "(at 0 1)" (Some [| 0.; 1. |]) [];
  check "(at 0)" None [ "1 expected (at X Y), found 1 word" ];
  check "(at 0 1 0)" None [ "1 expected (at X Y), found 3 words" ];
  check "(at 2 -1)" None
    [
      "5 X of (at ...) must be from 0 to 1, but is `2`";
      "7 Y of (at ...) must be from 0 to 1, but is `-1`";
    ]

let single () =
  let b = Quantity.scalar "R" Rule.above_zero in
  Piece.reads Float.equal b "(r 3)" 3.;
  Piece.refuses b "(r)" [ "1 expected (r R), found nothing" ];
  Piece.refuses b "(r 1 2)" [ "1 expected (r R), found 2 words" ];
  Piece.refuses b "(r 0)" [ "4 (r ...) must be above 0, but is `0`" ]

let wholes () =
  let b = Quantity.wholes "W H" ~min:1 ~max:9 in
  let reads = Piece.reads (fun (a : int array) b -> a = b) b in
  reads "(s 1 9)" [| 1; 9 |];
  reads "(s 01 0009)" [| 1; 9 |];
  Piece.refuses b "(s 0 10)"
    [
      "4 W of (s ...) must be from 1 to 9, but is `0`";
      "6 H of (s ...) must be from 1 to 9, but is `10`";
    ];
  Piece.refuses b "(s 1)" [ "1 expected (s W H), found 1 word" ];
  Piece.refuses b "(s 1 (2))" [ "6 expected a whole number, not (2 ...)" ]

let not_whole () =
  let b = Quantity.whole "N" ~min:min_int ~max:max_int in
  let check word =
    Piece.refuses b
      (Printf.sprintf "(n %s)" word)
      [ Printf.sprintf "4 `%s` is not a whole number" word ]
  in
  List.iter check
    [ "1.0"; "1e3"; "0x10"; "0b1"; "0o7"; "0u7"; "1_000"; "+1"; "--1"; "-" ];
  List.iter check [ "one"; "1-2"; "1-"; ".5"; "nan" ]

let large () =
  let b = Quantity.whole "N" ~min:0 ~max:max_int in
  Piece.reads Int.equal b (Printf.sprintf "(n %d)" max_int) max_int;
  Piece.reads Int.equal b "(n -0)" 0;
  let beyond = "4611686018427387904" in
  Piece.refuses b
    (Printf.sprintf "(n %s)" beyond)
    [
      Printf.sprintf "4 (n ...) must be from 0 to %d, but is `%s`" max_int
        beyond;
    ];
  Piece.refuses b "(n 99999999999999999999999999)"
    [
      Printf.sprintf
        "4 (n ...) must be from 0 to %d, but is `99999999999999999999999999`"
        max_int;
    ]

let between =
  law ~count:1000 "a whole number is read iff it is within its bounds"
    ~print:QCheck2.Print.(triple int int int)
    QCheck2.Gen.(
      let n = int_range (-12) 12 in
      triple n n (oneof [ n; int ]))
    (fun (a, b, n) ->
      let min = Int.min a b and max = Int.max a b in
      match
        Piece.body (Quantity.whole "N" ~min ~max) (Printf.sprintf "(n %d)" n)
      with
      | Some m, [] -> m = n && min <= n && n <= max
      | None, [ _ ] -> n < min || max < n
      | (Some _ | None), _ -> false)

let ruled =
  law ~count:1000 "a number is read iff it keeps to its rule"
    ~print:QCheck2.Print.(pair float float)
    QCheck2.Gen.(pair Piece.number (float_range (-0.5) 1.5))
    (fun (a, b) ->
      let text = Printf.sprintf "(n %h %h)" a b in
      match Piece.body (Quantity.numbers "A B" share) text with
      | Some [| a'; b' |], [] ->
          Piece.(same_bits a a' && same_bits b b')
          && Rule.broken share a = None
          && Rule.broken share b = None
      | None, messages ->
          List.length messages
          = List.length (List.filter_map (Rule.broken share) [ a; b ])
          && messages <> []
      | Some _, _ -> false)

let suite =
  ( "quantity",
    [
      case "a number keeps to its rule, or is called by its name" numbers;
      case "the hint is for what is no number" hints;
      case "there are as many numbers as names, each called by its own" named;
      case "a single number is called by its form" single;
      case "whole numbers keep to their bounds" wholes;
      case "what only some would call a whole number is refused" not_whole;
      case "whole numbers are read up to the largest" large;
      between;
      ruled;
    ] )
