open Candor_read
open Text

let refused what expected path =
  match Contents.of_file ~what:"a mesh" path with
  | Ok _ -> Alcotest.failf "%s was read" what
  | Error why -> Alcotest.(check string) what expected why

let whole () =
  Files.with_folder (fun folder ->
      let text = "a\000\r\n\255" in
      Alcotest.(check (result string string))
        "bytes" (Ok text)
        (Contents.of_file ~what:"a mesh" (Files.write folder "a" text));
      refused "a folder" "this is a folder, not a mesh" folder;
      refused "nothing" "there is no such file" (Filename.concat folder "b"))

let suite =
  ( "contents",
    [ case "a regular file is read to its end, and nothing else" whole ] )
