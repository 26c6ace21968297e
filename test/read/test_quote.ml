open Candor_read
open Text

let brief () =
  let check s expected =
    Alcotest.(check string) expected expected (Quote.brief s)
  in
  check "radius" "radius";
  check "\xc3\xa4" "\xc3\xa4";
  check "a\nb\x1b[" "a?b?[";
  check "\xff" "?";
  check (String.make 1000 'a') (String.make 37 'a' ^ "...")

let always_safe =
  law "no word of a scene puts a control byte into a message" QCheck2.Gen.string
    (fun s ->
      let b = Quote.brief s in
      String.length b <= 40
      && String.for_all (fun c -> c >= ' ' && c <> '\127') b)

let lists () =
  let check expected l =
    Alcotest.(check string) expected expected (Quote.list l)
  in
  check "" [];
  check "a" [ "a" ];
  check "a or b" [ "a"; "b" ];
  check "a, b or c" [ "a"; "b"; "c" ]

let counts () =
  let check expected n =
    Alcotest.(check string) expected expected (Quote.count n "error")
  in
  check "0 errors" 0;
  check "1 error" 1;
  check "2 errors" 2

let suite =
  ( "quote",
    [
      case "words are short and printable" brief;
      always_safe;
      case "lists end with or" lists;
      case "one error is one error" counts;
    ] )
