open Candor_read
open Text

(* The excerpt of [text] where the line [line] shows [column]. *)
let excerpt ?(mark = 0) ?(width = 1) text ~offset ~column =
  let source = Source.of_string ~name:"" text in
  let span = { Span.line = 1; column; offset; mark; width } in
  Excerpt.of_source source span

let check name expected e =
  let show (e : Excerpt.t) =
    Printf.sprintf "%s\n%s%s" e.text (String.make e.indent ' ')
      (String.make e.width '^')
  in
  Alcotest.(check (option string)) name expected (Option.map show e)

let short () =
  check "head" (Some "(sphere 1)\n ^^^^^^")
    (excerpt "(sphere 1)\n(box)" ~offset:0 ~column:1 ~mark:1 ~width:6);
  check "second line" (Some "(box)\n^")
    (excerpt "(sphere 1)\n(box)" ~offset:11 ~column:1);
  check "carriage return" (Some "(box)\n^")
    (excerpt "(box)\r\n(a)" ~offset:0 ~column:1);
  check "over the end" (Some "ab\n ^")
    (excerpt "ab\ncd" ~offset:1 ~column:2 ~width:5);
  check "at the end" (Some "ab\n  ^") (excerpt "ab" ~offset:2 ~column:3);
  check "nothing" None (excerpt "" ~offset:0 ~column:1)

let columns () =
  check "tab" (Some "a b\n  ^") (excerpt "a\tb" ~offset:2 ~column:3);
  check "control" (Some "??b\n  ^") (excerpt "\027\127b" ~offset:2 ~column:3);
  check "letters of two bytes" (Some "\xc3\xa4b\n ^")
    (excerpt "\xc3\xa4b" ~offset:2 ~column:3);
  check "no letters" (Some "??b\n  ^") (excerpt "\xc3\xffb" ~offset:2 ~column:3);
  check "C1" (Some "?b\n ^") (excerpt "\xc2\x9bb" ~offset:2 ~column:3)

let long () =
  let line = String.concat " " (List.init 100 string_of_int) in
  check "start"
    (Some
       "0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 \
        26...\n\
        ^")
    (excerpt line ~offset:0 ~column:1);
  check "middle"
    (Some
       "...9 40 41 42 43 44 45 46 47 48 49 50 51 52 53 54 55 56 57 58 59 60 61 \
        62...\n\
       \                                      ^^")
    (excerpt line ~offset:143 ~column:144 ~width:2)

let gen =
  QCheck2.Gen.(
    pair
      (string_size ~gen:(char_range '\000' '\255') (int_range 0 500))
      (int_range 0 500))

let always_fits =
  law ~count:2000
    "an excerpt is one line of at most 76 columns with its mark in it" gen
    (fun (s, at) ->
      let s = String.map (fun c -> if c = '\n' then ' ' else c) s in
      let at = min at (String.length s) in
      match excerpt s ~offset:at ~column:(at + 1) ~width:7 with
      | None -> s = ""
      | Some e ->
          let columns =
            String.fold_left
              (fun n c -> if Char.code c land 0xC0 = 0x80 then n else n + 1)
              0 e.text
          in
          columns <= 76
          && e.indent + e.width <= columns + 1
          && String.for_all (fun c -> c >= ' ' && c <> '\127') e.text)

let suite =
  ( "excerpt",
    [
      case "a short line is shown whole" short;
      case "every character takes one column" columns;
      case "of a long line the part around the mark is shown" long;
      always_fits;
    ] )
