open Candor_read
open Text

let ends s = String.fold_left Span.after Span.start s

let lines () =
  let check s expected =
    Alcotest.(check string) expected expected (Span.to_string (ends s))
  in
  check "" "1:1";
  check "abc" "1:4";
  check "abc\n" "2:1";
  check "\r\n\xc3\xa4" "2:3"

let there_and_back =
  law "a place is the same to the parser" QCheck2.Gen.string (fun s ->
      let span = ends s in
      Span.of_position (Span.to_position span) = span
      && span.offset = String.length s)

let suite =
  ( "span",
    [
      case "lines and columns count from 1, columns bytes" lines; there_and_back;
    ] )
