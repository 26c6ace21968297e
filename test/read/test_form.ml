open Candor_read
open Text

let forms () =
  let check text expected =
    let found =
      Option.map
        (fun (f : Form.t) -> (f.head, List.length f.body))
        (Form.of_located (Piece.first text))
    in
    Alcotest.(check (option (pair string int))) text expected found
  in
  check "(sphere (center 0 0 0) (radius 1))" (Some ("sphere", 2));
  check "(caps)" (Some ("caps", 0));
  check "(1 2 3)" (Some ("1", 2));
  check "(\"two words\" 3)" (Some ("two words", 1));
  check "()" None;
  check "((a) b)" None;
  check "a" None

let where () =
  let f = Piece.form "\n  (a (b) c)" in
  let places = List.map (fun (s : Located.t) -> Span.to_string s.span) f.body in
  Alcotest.(check string) "form" "2:3" (Span.to_string f.span);
  Alcotest.(check (list string)) "body" [ "2:6"; "2:10" ] places

let titles () =
  let check = Alcotest.(check string) in
  check "a form" "(sphere ...)" (Form.title "sphere");
  check "a list" "this list" (Form.title "");
  check "arguments" "(at X Y Z)" (Form.synopsis "at" "X Y Z");
  check "no arguments" "(caps)" (Form.synopsis "caps" "");
  check "no head" "(X Y Z)" (Form.synopsis "" "X Y Z")

let quotes () =
  let check text expected =
    Alcotest.(check string) text expected (Form.quote (Piece.first text))
  in
  check "word" "`word`";
  check "\"two words\"" "`two words`";
  check "(sphere (radius 1))" "(sphere ...)";
  check "()" "()";
  check "((a))" "a list";
  check
    (Printf.sprintf "(%s)" (String.make 50 'x'))
    (Printf.sprintf "(%s... ...)" (String.make 37 'x'))

let founds () =
  let check text expected =
    Alcotest.(check string) text expected (Form.found (Piece.form text))
  in
  check "(f)" "nothing";
  check "(f 1)" "1 word";
  check "(f 1 2)" "2 words";
  check "(f (1))" "1 item";
  check "(f 1 (2) 3)" "3 items"

let hints () =
  let check word among expected =
    Alcotest.(check (option string)) word expected (Form.unexpected word ~among)
  in
  let words = [ "radius"; "center" ] in
  check "radios" words (Some "did you mean `radius`?");
  check "banana" words (Some "expected radius or center");
  check "" words (Some "expected radius or center");
  check "banana" [] None;
  let many n = List.init n (Printf.sprintf "w%d0000") in
  is "twelve are told" true (Form.unexpected "banana" ~among:(many 12) <> None);
  check "banana" (many 13) None;
  check "w120001" (many 13) (Some "did you mean `w120000`?")

let suite =
  ( "form",
    [
      case "a form is a list that begins with a word" forms;
      case "a form knows where it and its parts stand" where;
      case "titles and synopses name what is meant" titles;
      case "an expression is quoted in short" quotes;
      case "what is found is counted" founds;
      case "an unexpected word is told what was meant, or what there is" hints;
    ] )
