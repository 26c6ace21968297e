open Candor_read
open Text

let outline ?(bare = false) s =
  String.fold_left Outline.feed (Outline.start ~bare Span.start) s

let show (u : Outline.unclosed) =
  match u with
  | Nothing -> "nothing"
  | Quotation s -> "string at " ^ Span.to_string s
  | Comment s -> "comment at " ^ Span.to_string s
  | Parenthesis { opened; doubt = None } -> "( at " ^ Span.to_string opened
  | Parenthesis { opened; doubt = Some line } ->
      Printf.sprintf "( at %s, line %d" (Span.to_string opened) line

let check ?bare s expected =
  Alcotest.(check string) s expected (show (Outline.unclosed (outline ?bare s)))

let kinds () =
  check "" "nothing";
  check "(a (b) c)" "nothing";
  check "(a (b" "( at 1:4";
  check "(a \"b" "string at 1:4";
  check "(a \"b\\\"" "string at 1:4";
  check "(a \"\\\\\"" "( at 1:1";
  check "(a #|b" "comment at 1:4";
  check "(a #|b #| |#" "comment at 1:4";
  check "(a #|b #| |# |#)" "nothing";
  check "(a #| \"|#\" |#)" "nothing";
  check "(a ; \" ( #|\n)" "nothing";
  check "(a #; (b))" "nothing";
  check ")) (" "( at 1:4"

let blame () =
  check "(scene\n  (sphere (center 0 0 0)\n  (box))" "( at 2:3, line 3";
  check "(scene\n  (sphere (center 0 0 0)\n    (radius 1)\n" "( at 2:3";
  check "(scene\n(sphere)\n(box)\n" "( at 1:1";
  check "(scene\n(sphere\n(box)\n" "( at 2:1, line 3";
  check ~bare:true "(sphere\n(box)\n" "( at 1:1, line 2";
  check "(sphere\n(box)\n" "( at 1:1"

let blank () =
  let check expected s =
    Alcotest.(check bool) s expected (Outline.is_blank (outline s))
  in
  List.iter (check true) [ ""; " \t\r\n"; "; (a)\n"; "#| ( \" ( \" |# "; "#|" ];
  List.iter (check false) [ "a"; "("; ")"; "\""; "#;"; "#a"; "; \n x" ]

let text =
  QCheck2.Gen.(
    map (String.concat "")
      (list_size (int_range 0 30)
         (oneof
            (List.map return
               [ "("; ")"; "\""; "\\"; "#"; "|"; ";"; "\n"; " "; "a"; "1" ]))))

(* The parser has the last word on what is open; this only says where. *)
let agrees =
  law ~count:20_000 ~print:String.escaped "what the parser calls open is open"
    text (fun s ->
      match Parsexp.Many.parse_string s with
      | Ok _ -> show (Outline.unclosed (outline s)) = "nothing"
      | Error e -> (
          let open_ = show (Outline.unclosed (outline s)) in
          match Parsexp.Parse_error.message e with
          | "unclosed parentheses at end of input" ->
              String.starts_with ~prefix:"(" open_
          | "unterminated quoted string" ->
              String.starts_with ~prefix:"string" open_
          | "unterminated block comment" ->
              String.starts_with ~prefix:"comment" open_
          | _ -> true))

let suite =
  ( "outline",
    [
      case "strings, comments and parentheses are told apart" kinds;
      case "indentation tells which parenthesis is not closed" blame;
      case "comments are blank" blank;
      agrees;
    ] )
