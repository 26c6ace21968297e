open Candor_read
open Text

let iter ?(bare = false) text =
  let forms = ref [] in
  let rec show (s : Located.t) =
    match s.node with
    | Atom a -> a
    | List l -> "(" ^ String.concat " " (List.map show l) ^ ")"
  in
  let add (form : Located.t) =
    forms := (Span.to_string form.span ^ " " ^ show form) :: !forms
  in
  let ended =
    match Forms.iter (Source.of_string ~name:"" text) ~bare add with
    | Ok span -> "ok " ^ Span.to_string span
    | Error { span = Some span; message; _ } ->
        Span.to_string span ^ " " ^ message
    | Error { span = None; message; _ } -> message
  in
  (List.rev !forms, ended)

let check ?bare text forms ended =
  Alcotest.(check (pair (list string) string))
    text (forms, ended) (iter ?bare text)

let within () =
  check "(scene)" [] "ok 1:2";
  check " ; a\n ( scene (a) b(c (d)))\n ;"
    [ "2:10 (a)"; "2:14 b"; "2:15 (c (d))" ]
    "ok 2:4";
  check "#| ( |# (scene (a))" [ "1:16 (a)" ] "ok 1:10";
  check "\xEF\xBB\xBF(scene a)" [ "1:8 a" ] "ok 1:2";
  check "(scene\r\n a)\r\n" [ "2:2 a" ] "ok 1:2";
  check "(scene a scene)" [ "1:8 a"; "1:10 scene" ] "ok 1:2"

let bare () =
  check ~bare:true "" [] "ok 1:1";
  check ~bare:true " (a)b" [ "1:2 (a)"; "1:5 b" ] "ok 1:1";
  check ~bare:true "(a) (scene (b))" [ "1:1 (a)" ]
    "1:5 an included file has no (scene ...) around its forms";
  check ~bare:true "(a))" [ "1:1 (a)" ] "1:4 this `)` closes nothing"

let faults () =
  check "" [] "1:1 there is nothing here: expected (scene ...)";
  check "x" [] "1:1 expected (scene ...)";
  check "()" [] "1:2 expected (scene ...)";
  check "((scene))" [] "1:2 expected (scene ...)";
  check "(scene a" [ "1:8 a" ] "1:1 this `(` is never closed";
  check "(scene a) b" [ "1:8 a" ]
    "1:11 nothing may follow the end of (scene ...)";
  check "(scene a))" [ "1:8 a" ] "1:10 this `)` closes nothing";
  check "(scene (a) \"b" [ "1:8 (a)" ] "1:12 this string is never closed";
  check "(scene (a)) \"b" [ "1:8 (a)" ] "1:13 this string is never closed";
  check "(scene (a) \000 (b))" [ "1:8 (a)" ] "1:12 a scene holds no NUL bytes"

(* The seams of chunks fall everywhere in this. *)
let chunks () =
  let forms = 40_000 in
  let text =
    "(scene"
    ^ String.concat "" (List.init forms (fun i -> Printf.sprintf " (f %d)" i))
    ^ ")"
  in
  let found, ended = iter text in
  Alcotest.(check int) "forms" forms (List.length found);
  Alcotest.(check string) "end" "ok 1:2" ended

let suite =
  ( "forms",
    [
      case "the forms in (scene ...) come one by one" within;
      case "the forms of an included file come one by one" bare;
      case "what is wrong with a text is told after its forms" faults;
      case "a text of many chunks is one text" chunks;
    ] )
