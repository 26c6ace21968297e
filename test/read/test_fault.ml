open Candor_read
open Text

let span line column offset = { Span.start with line; column; offset }

let parse_error text =
  match Parsexp.Many.parse_string text with Ok _ -> None | Error e -> Some e

let error text =
  match parse_error text with
  | Some e -> e
  | None -> Alcotest.failf "%S has no fault" text

let parts (f : Fault.t) =
  (Option.map Span.to_string f.span, f.message, f.hint, f.distrust)

let check name expected f =
  is (Printf.sprintf "%s, not %s" name f.Fault.message) true (expected = parts f)

let trusting () =
  check "with a hint"
    (Some "2:3", "why", Some "how", max_int)
    (Fault.v ~hint:"how" (span 2 3 9) "why");
  check "without" (Some "1:1", "why", None, max_int) (Fault.v Span.start "why");
  check "nowhere"
    (None, "it is a directory", None, max_int)
    (Fault.unreadable "it is a directory")

let words () =
  check "a stray parenthesis"
    (Some "1:5", "this `)` closes nothing", None, max_int)
    (Fault.of_parser (error "(a) )"));
  check "a carriage return"
    (Some "2:2", "expected a line feed after a carriage return", None, max_int)
    (Fault.of_parser (error "a\n\rb"));
  let e = error "(a |# b" in
  let f = Fault.of_parser e in
  Alcotest.(check string)
    "anything else in the words of the parser"
    (Parsexp.Parse_error.message e)
    f.message

(* The text up to a `)` that closes nothing is without fault, but that a [#;] may
   wait for what it hides. *)
let padding = String.concat "" (List.init 20 (fun _ -> " 0"))

let stray =
  law ~count:5000 ~print:String.escaped
    "what closes nothing is a `)`, and only that" Test_outline.text (fun s ->
      match parse_error s with
      | None -> true
      | Some e ->
          let at = (Parsexp.Parse_error.position e).offset in
          let closes =
            at < String.length s
            && s.[at] = ')'
            && parse_error (String.sub s 0 at ^ padding) = None
          in
          Fault.closes_nothing e = closes)

let otherwise = Fault.v (span 9 9 99) "something else"

let unclosed ?(bare = false) ?(start = Span.start) text =
  Fault.unclosed (Source.of_string ~name:"" text) ~bare start ~otherwise

let open_ends () =
  check "nothing" (parts otherwise) (unclosed "(a (b) \"c\")");
  check "a string"
    (Some "1:4", "this string is never closed", None, max_int)
    (unclosed "(a \"b");
  check "a comment"
    (Some "1:4", "this comment is never closed: expected `|#`", None, max_int)
    (unclosed "(a #| (b");
  check "a parenthesis"
    (Some "1:4", "this `(` is never closed", None, 3)
    (unclosed "(a (b");
  check "a parenthesis that a line doubts"
    ( Some "2:3",
      "this `(` is never closed",
      Some "line 3 begins as if it were",
      9 )
    (unclosed "(scene\n  (sphere\n  (box))");
  check "one around everything"
    (Some "1:1", "this `(` is never closed", None, 0)
    (unclosed "(a\n(b)");
  check "the same among others"
    ( Some "1:1",
      "this `(` is never closed",
      Some "line 2 begins as if it were",
      0 )
    (unclosed ~bare:true "(a\n(b)")

let from_start () =
  let text = "(\n\"\n(a" in
  check "behind the string"
    (Some "3:1", "this `(` is never closed", None, 4)
    (unclosed ~start:(span 3 1 4) text);
  check "from the top"
    (Some "2:1", "this string is never closed", None, max_int)
    (unclosed text)

(* Longer than what is read at a time. *)
let long () =
  let lines = Source.most in
  let text = String.concat "" [ String.make lines '\n'; "(a)\n ("; "b" ] in
  check "far down"
    ( Some (Printf.sprintf "%d:2" (lines + 2)),
      "this `(` is never closed",
      None,
      lines + 5 )
    (unclosed text)

let suite =
  ( "fault",
    [
      case "a fault leaves what was read before it intact" trusting;
      case "what the parser says is put in our words" words;
      stray;
      case "what is open at the end is told, and nothing after it trusted"
        open_ends;
      case "a text is read again from where it is said" from_start;
      case "the place is right however long the text" long;
    ] )
