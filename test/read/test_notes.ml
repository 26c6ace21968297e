open Candor_read
open Text

let source name = Source.of_string ~name "one\ntwo\nthree"
let span line offset = { Span.start with line; offset; column = 1 }
let refuse n span message = Notes.error n span message

let shown n =
  List.map
    (fun (e : Error.t) ->
      Candor_scene.Place.to_string e.place ^ " " ^ e.message)
    (Notes.report n).errors

let order () =
  let n = Notes.make () in
  let a = Notes.within n (source "a") in
  let b = Notes.within n (source "b") in
  refuse b (span 1 0) "b1";
  refuse a (span 2 4) "a2";
  refuse a (span 1 0) "a1";
  refuse a (span 1 0) "a1";
  Alcotest.(check (list string))
    "sorted"
    [ "a:1:1 a1"; "a:2:1 a2"; "b:1:1 b1" ]
    (shown n);
  Alcotest.(check bool) "clean" false (Notes.is_clean n)

let bounded () =
  let n = Notes.make () in
  let a = Notes.within n (source "a") in
  for i = 1 to 5000 do
    refuse a (span i i) "x"
  done;
  let report = Notes.report n in
  Alcotest.(check int) "shown" Error.most (List.length report.errors);
  Alcotest.(check int) "more" (5000 - Error.most) report.more

let distrust () =
  let n = Notes.make () in
  let a = Notes.within n (source "a") in
  let b = Notes.within n (source "b") in
  refuse a (span 1 0) "kept";
  refuse a (span 2 4) "forgotten";
  refuse b (span 3 8) "of another file";
  Notes.fault a { (Fault.v (span 2 4) "fault") with distrust = 4 };
  Alcotest.(check (list string))
    "left"
    [ "a:1:1 kept"; "a:2:1 fault"; "b:3:1 of another file" ]
    (shown n);
  Alcotest.(check bool) "incomplete" true (Notes.incomplete n)

let mentions () =
  let n = Notes.make () in
  let a = Notes.within n (source "a") in
  let mention line name =
    ignore (Notes.mention a Material name (span line line))
  in
  mention 3 "red";
  mention 1 "read";
  mention 2 "red";
  Notes.check_mentions n Definition ~is_known:(fun _ -> false) ~known:[];
  Alcotest.(check (list string)) "none" [] (shown n);
  Notes.check_mentions n Material ~is_known:(String.equal "read")
    ~known:[ "read" ];
  Alcotest.(check (list string))
    "one"
    [ "a:3:1 no material is called `red` (used 2 times)" ]
    (shown n)

let shared () =
  let n = Notes.make () in
  let mention s = Notes.mention n Material s Span.start in
  let first = mention (String.concat "" [ "r"; "ed" ]) in
  Alcotest.(check bool)
    "one copy" true
    (first == mention (String.concat "" [ "re"; "d" ]))

let by_place () =
  let n = Notes.make () in
  let a = Notes.within n (source "a") in
  let b = Notes.within n (source "b") in
  let place file line column = { Candor_scene.Place.file; line; column } in
  refuse b (span 1 0) "b1";
  refuse a (span 3 8) "a3";
  Notes.error_at n (place "a" 2 1) ~hint:"h" "a2";
  Notes.error_at b (place "a" 2 1) ~hint:"h" "a2";
  Notes.error_at n (place "b" 9 9) "b9, a line that is gone";
  Alcotest.(check (list string))
    "sorted"
    [ "a:2:1 a2"; "a:3:1 a3"; "b:9:9 b9, a line that is gone"; "b:1:1 b1" ]
    (shown n);
  match (Notes.report n).errors with
  | { excerpt = Some e; hint; _ } :: _ ->
      Alcotest.(check string) "excerpt" "two" e.text;
      Alcotest.(check (option string)) "hint" (Some "h") hint
  | _ -> Alcotest.fail "no excerpt"

let pictures () =
  let n = Notes.make () in
  let loads = ref 0 in
  let load () =
    incr loads;
    Error "no"
  in
  let ask key = is key true (Result.is_error (Notes.picture n key load)) in
  List.iter ask [ "a"; "b"; "a"; "a"; "b" ];
  Alcotest.(check int) "loads" 2 !loads

let suite =
  ( "notes",
    [
      case "errors come in the order of their places, each once" order;
      case "beyond a thousand errors are only counted" bounded;
      case "what follows an unclosed parenthesis is not judged" distrust;
      case "a name that means nothing is told at its first mention" mentions;
      case "a name is kept once" shared;
      case "an error by place is one like any other" by_place;
      case "a picture is loaded once" pictures;
    ] )
