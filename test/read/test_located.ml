open Candor_read
open Text

let located s =
  match Parsexp.Single_and_positions.parse_string s with
  | Error e -> Alcotest.fail (Parsexp.Parse_error.message e)
  | Ok parsed -> (
      match Located.of_parsed parsed with
      | Ok located -> located
      | Error (_, why) -> Alcotest.fail why)

let rec places (s : Located.t) =
  let here =
    Printf.sprintf "%s+%d.%d@%d" (Span.to_string s.span) s.span.mark
      s.span.width s.span.offset
  in
  match s.node with
  | Atom a -> [ a ^ " " ^ here ]
  | List items -> ("() " ^ here) :: List.concat_map places items

let where () =
  Alcotest.(check (list string))
    "places"
    [
      "() 1:2+1.1@1";
      "a 1:3+0.1@2";
      "() 2:2+0.1@5";
      "() 2:3+1.2@6";
      "bc 2:4+0.2@7";
      "d e 2:7+0.5@10";
    ]
    (places (located " (a\n ((bc \"d e\")))"))

let heads () =
  let check s expected =
    Alcotest.(check (option string)) s expected (Located.head (located s))
  in
  check "(a b)" (Some "a");
  check "()" None;
  check "((a))" None;
  check "a" None

let suite =
  ( "located",
    [
      case "everything knows its line, column, offset and width" where;
      case "the head of a list is the word that it begins with" heads;
    ] )
