open Candor_read
open Text

(* A small language of its own, to see each part of a reader at work. *)
let thing =
  let open Fields in
  fields
    (let+ a = field "aim" (Quantity.numbers "X Y" Rule.any)
     and+ b = optional "bend" (Quantity.scalar "N" Rule.above_zero)
     and+ c = present "closed"
     and+ d = default "depth" (Quantity.whole "N" ~min:0 ~max:9) 7 in
     (a.(0) +. a.(1), b, c, d))

let pair =
  let open Fields in
  fields
    (let+ items = items (Decode.tuple (Quantity.numbers "X" Rule.any)) in
     List.length items)

let language =
  let nothing = (0., None, false, 0) in
  Decode.choice "thing"
    [
      ("thing", thing);
      ("pair", Decode.map (fun n -> (float_of_int n, None, false, n)) pair);
      ( "word",
        Decode.one "WORD" (Decode.word [ ("yes", nothing); ("no", nothing) ]) );
      ("named", Decode.map (fun (_, _, _) -> nothing) (Decode.named thing));
    ]

(* What is read in [s], and the messages about it. *)
let read s =
  let notes = Notes.within (Notes.make ()) (Source.of_string ~name:"" s) in
  let value = ref None in
  let add form = value := Decode.read language notes form in
  ignore (Forms.iter (Source.of_string ~name:"" s) ~bare:true add);
  let message (e : Error.t) =
    Printf.sprintf "%d %s%s" e.place.column e.message
      (Option.fold e.hint ~none:"" ~some:(fun h -> "; " ^ h))
  in
  (!value, List.map message (Notes.report notes).errors)

let values () =
  let check s expected =
    Alcotest.(check bool) s true (read s = (Some expected, []))
  in
  check "(thing (aim 1 2))" (3., None, false, 7);
  check "(thing (depth 0) (closed) (bend .5) (aim 1 2))" (3., Some 0.5, true, 0);
  check "(pair (1) (2))" (2., None, false, 2);
  check "(word no)" (0., None, false, 0)

let check s expected =
  let value, messages = read s in
  Alcotest.(check (list string)) s expected messages;
  Alcotest.(check bool) (s ^ " gives nothing") true (Option.is_none value)

let fields () =
  check "(thing)" [ "1 (thing ...) needs (aim X Y)" ];
  check "(thing (aim 1))" [ "8 expected (aim X Y), found 1 word" ];
  check "(thing (aim 1 2) (bend 0))"
    [ "24 (bend ...) must be above 0, but is `0`" ];
  check "(thing (aim x 2) (bend 0))"
    [ "13 `x` is not a number"; "24 (bend ...) must be above 0, but is `0`" ];
  check "(thing (aim 1 2) (closed 1))" [ "18 expected (closed), found 1 word" ];
  check "(thing (aim 1 2) (depth 10))"
    [ "25 (depth ...) must be from 0 to 9, but is `10`" ];
  check "(thing (aim 1 2) (aim 1 2) (aim 1 2))"
    [
      "18 (aim ...) is given twice in (thing ...); the first is at 1:8";
      "28 (aim ...) is given twice in (thing ...); the first is at 1:8";
    ]

let no_cascades () =
  check "(thing (aims 1 2))"
    [ "8 unknown field `aims` in (thing ...); did you mean `aim`?" ];
  check "(thing (aims 1))"
    [ "8 unknown field `aims` in (thing ...); did you mean `aim`?" ];
  check "(thing (other 1 2))"
    [
      "8 unknown field `other` in (thing ...); expected aim, bend, closed or \
       depth";
    ];
  check "(thing aim 1 2)"
    [
      "8 `aim` has no place in (thing ...); expected aim, bend, closed or depth";
    ];
  check "(thing (aim 1 2) (sphere) (box) (light))"
    [
      "18 (sphere ...) has no place in (thing ...); it belongs to the top \
       level: is a `)` missing before it?";
    ];
  check "(pair (1) (x) (1 2))"
    [
      "11 unknown field `x` in (pair ...); expected (X)";
      "15 expected (X), found 2 words";
    ]

let choices () =
  check "(thin (aim 1 2))" [ "1 unknown thing `thin`; did you mean `thing`?" ];
  check "(banana)"
    [ "1 unknown thing `banana`; expected thing, pair, word or named" ];
  check "(thin)" [ "1 unknown thing `thin`; did you mean `thing`?" ];
  check "thing" [ "1 expected a thing, not `thing`; did you mean (thing ...)?" ];
  check "()"
    [ "1 expected a thing, not (); expected thing, pair, word or named" ];
  check "(word maybe)" [ "7 expected `yes` or `no`, not `maybe`" ];
  check "(word (no))" [ "7 expected `yes` or `no`, not (no ...)" ];
  check "(word)" [ "1 expected (word WORD), found nothing" ];
  check "(named)" [ "1 expected a name: (named NAME ...)" ]

let named () =
  let _, messages = read "(named me (bend 1))" in
  Alcotest.(check (list string))
    "title"
    [ "1 (named me ...) needs (aim X Y)" ]
    messages

let suite =
  ( "decode",
    [
      case "fields are read in any order, with defaults" values;
      case "each wrong field is told" fields;
      case "one mistake gives one message" no_cascades;
      case "a form is one of a few" choices;
      case "messages about a named form tell its name" named;
    ] )
