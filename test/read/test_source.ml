open Candor_read
open Text

let open_ok ?patience path =
  match Source.open_file ?patience path with
  | Ok s -> s
  | Error why -> Alcotest.failf "%s: %s" path why

let drain s =
  let buffer = Bytes.create 7 and all = Buffer.create 100 in
  let rec go () =
    match Source.input s buffer with
    | Ok 0 -> Ok (Buffer.contents all)
    | Ok n ->
        Buffer.add_subbytes all buffer 0 n;
        go ()
    | Error _ as e -> e
  in
  let text = go () in
  Source.close s;
  text

let check_text name expected s =
  Alcotest.(check (result string string)) name (Ok expected) (drain s);
  Alcotest.(check string)
    "slice" (String.sub expected 2 3)
    (Source.slice s ~first:2 ~last:5);
  Alcotest.(check string)
    "slice beyond the end"
    (String.sub expected 4 (String.length expected - 4))
    (Source.slice s ~first:4 ~last:max_int);
  Alcotest.(check string)
    "slice behind the end" ""
    (Source.slice s ~first:1000 ~last:2000)

let text = "a text of a few words"
let strings () = check_text "string" text (Source.of_string ~name:"x" text)

let files () =
  Files.with_folder (fun folder ->
      check_text "file" text (open_ok (Files.write folder "a" text)))

let pipes () =
  Files.with_pipe ~text (fun path -> check_text "pipe" text (open_ok path))

let refused path =
  match Source.open_file path with
  | Ok s ->
      Source.close s;
      Alcotest.failf "%s can be opened" path
  | Error why -> why

let failures () =
  let check path why = Alcotest.(check string) path why (refused path) in
  check "/nowhere/at/all" "there is no such file";
  check "a\000b" "there is no such file";
  check "/tmp" "this is a folder, not a scene";
  check (String.make 5000 'a') "cannot be read: file name too long"

let silence () =
  Files.with_folder (fun folder ->
      let path = Filename.concat folder "pipe" in
      Unix.mkfifo path 0o600;
      Alcotest.(check (result string string))
        "silent" (Error "nothing came through this pipe for 0.05 s")
        (drain (open_ok ~patience:0.05 path)))

let sameness () =
  Files.with_folder (fun folder ->
      let path = Files.write folder "a" text in
      let roundabout =
        Filename.concat folder ("../" ^ Filename.basename folder ^ "/a")
      in
      let a = open_ok path and b = open_ok roundabout in
      let other = open_ok (Files.write folder "b" text) in
      Alcotest.(check bool) "one file" true (Source.same a b);
      Alcotest.(check bool) "two files" false (Source.same a other);
      Alcotest.(check bool)
        "a text by its name" true
        (Source.same (Source.of_string ~name:path "") a);
      List.iter Source.close [ a; b; other ])

let neighbours () =
  let check name path expected =
    Alcotest.(check string)
      expected expected
      (Source.beside (Source.of_string ~name "") path)
  in
  check "a.scene" "b.scene" "b.scene";
  check "x/a.scene" "b.scene" "x/b.scene";
  check "x/a.scene" "../b.scene" "x/../b.scene";
  check "x/a.scene" "/b.scene" "/b.scene";
  check "" "b.scene" "b.scene"

let suite =
  ( "source",
    [
      case "a string is read in pieces, and again in part" strings;
      case "a file is read in pieces, and again in part" files;
      case "a pipe is read like a file" pipes;
      case "what cannot be read is told from what can" failures;
      case "a pipe that stays silent does not hang the reader" silence;
      case "a file is the same by any name" sameness;
      case "paths start from the folder of the file" neighbours;
    ] )
