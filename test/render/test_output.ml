open Candor_render
open Candor_oracle

let read name = In_channel.with_open_bin name In_channel.input_all

let write name text =
  Out_channel.with_open_bin name (fun c -> Out_channel.output_string c text)

let entries folder =
  List.sort String.compare (Array.to_list (Sys.readdir folder))

let in_folder f () =
  let folder = Filename.temp_dir "candor" "output" in
  let in_it name = Filename.concat folder name in
  Fun.protect
    (fun () -> f folder in_it)
    ~finally:(fun () ->
      List.iter
        (fun e ->
          let e = in_it e in
          if Sys.is_directory e then Sys.rmdir e else Sys.remove e)
        (entries folder);
      Sys.rmdir folder)

let ok = function Ok x -> x | Error why -> Alcotest.fail why
let names = Alcotest.(list string)

let fails part = function
  | Ok _ -> Alcotest.fail "an error is expected"
  | Error why ->
      let holds =
        List.exists
          (fun i ->
            i + String.length part <= String.length why
            && String.sub why i (String.length part) = part)
          (List.init (String.length why) Fun.id)
      in
      if not holds then Alcotest.failf "expected %S in %S" part why

let whole folder file =
  let target = file "a.ppm" in
  ok (Output.write target "first");
  Alcotest.(check string) "new" "first" (read target);
  ok (Output.write target "second");
  Alcotest.(check string) "replaced" "second" (read target);
  Alcotest.check names "nothing else is left" [ "a.ppm" ] (entries folder)

let before_and_after folder file =
  let target = file "a.ppm" in
  write target "old";
  let f = ok (Output.open_ target) in
  Alcotest.(check string) "as it was" "old" (read target);
  Alcotest.(check int)
    "a temporary file beside it" 2
    (List.length (entries folder));
  ok (Output.commit f "new");
  Alcotest.(check string) "the new text" "new" (read target);
  Alcotest.check names "alone" [ "a.ppm" ] (entries folder)

(* Who has the old file open goes on reading the old text. *)
let readers _ file =
  let target = file "a.ppm" in
  write target "old text";
  In_channel.with_open_bin target (fun c ->
      let first = Option.get (In_channel.input_char c) in
      ok (Output.write target "NEW TEXT");
      Alcotest.(check string)
        "half read" "old text"
        (String.make 1 first ^ In_channel.input_all c))

let discarded folder file =
  let target = file "a.ppm" in
  write target "old";
  Output.discard (ok (Output.open_ target));
  Alcotest.(check string) "as it was" "old" (read target);
  Alcotest.check names "nothing is left" [ "a.ppm" ] (entries folder);
  Output.discard (ok (Output.open_ (file "b.ppm")));
  Alcotest.check names "no new file" [ "a.ppm" ] (entries folder)

let two_at_once folder file =
  let target = file "a.ppm" in
  let f = ok (Output.open_ target) in
  let g = ok (Output.open_ target) in
  ok (Output.commit f "one");
  ok (Output.commit g "two");
  Alcotest.(check string) "the last one counts" "two" (read target);
  Alcotest.check names "alone" [ "a.ppm" ] (entries folder)

let refused folder file =
  Sys.mkdir (file "d.ppm") 0o777;
  fails "directory" (Output.open_ (file "d.ppm"));
  fails "directory" (Output.open_ folder);
  fails (file "no/where.ppm") (Output.open_ (file "no/where.ppm"));
  fails "no such file" (Output.open_ (file "no/where.ppm"));
  write (file "f") "";
  fails "not a directory" (Output.open_ (file "f/x.ppm"));
  Alcotest.check names "nothing is left" [ "d.ppm"; "f" ] (entries folder)

let read_only folder file =
  (* root may write anywhere *)
  if Unix.geteuid () <> 0 then (
    write (file "a.ppm") "old";
    Unix.chmod (file "a.ppm") 0o444;
    fails "permission" (Output.open_ (file "a.ppm"));
    Unix.chmod folder 0o555;
    fails "permission" (Output.open_ (file "b.ppm"));
    Unix.chmod folder 0o755);
  fails "cannot write" (Output.open_ "/proc/candor.ppm")

let gone folder file =
  Sys.mkdir (file "d") 0o777;
  let f = ok (Output.open_ (file "d/a.ppm")) in
  List.iter (fun e -> Sys.remove (file ("d/" ^ e))) (entries (file "d"));
  Sys.rmdir (file "d");
  fails "cannot write" (Output.commit f "text");
  Alcotest.check names "nothing is left" [] (entries folder)

(* The target becomes a directory while the picture is made. *)
let taken folder file =
  let f = ok (Output.open_ (file "a.ppm")) in
  Sys.mkdir (file "a.ppm") 0o777;
  fails "cannot write" (Output.commit f "text");
  Alcotest.check names "no temporary file" [ "a.ppm" ] (entries folder)

let link folder file =
  write (file "real.ppm") "old";
  Unix.symlink "real.ppm" (file "link.ppm");
  ok (Output.write (file "link.ppm") "new");
  Alcotest.(check bool)
    "still a link" true
    ((Unix.lstat (file "link.ppm")).st_kind = S_LNK);
  Alcotest.(check string) "to the new text" "new" (read (file "real.ppm"));
  Alcotest.check names "nothing else" [ "link.ppm"; "real.ppm" ]
    (entries folder)

let fifo folder file =
  let pipe = file "p.ppm" in
  Unix.mkfifo pipe 0o666;
  let reader = Unix.openfile pipe [ O_RDONLY; O_NONBLOCK ] 0 in
  ok (Output.write pipe "through");
  let b = Bytes.create 99 in
  Alcotest.(check string)
    "what came through" "through"
    (Bytes.sub_string b 0 (Unix.read reader b 0 99));
  Unix.close reader;
  Alcotest.(check bool) "still a pipe" true ((Unix.stat pipe).st_kind = S_FIFO);
  Alcotest.check names "nothing else" [ "p.ppm" ] (entries folder);
  (* Its reader goes away. *)
  let reader = Unix.openfile pipe [ O_RDONLY; O_NONBLOCK ] 0 in
  let f = ok (Output.open_ pipe) in
  Unix.close reader;
  fails "broken pipe" (Output.commit f "too late")

let full _ file =
  if Sys.file_exists "/dev/full" then (
    Unix.symlink "/dev/full" (file "full.ppm");
    fails "no space left" (Output.write (file "full.ppm") "text"))

let long_names folder file =
  List.iter
    (fun n ->
      let name = String.make n 'x' ^ ".ppm" in
      ok (Output.write (file name) "text");
      Alcotest.check names (string_of_int n) [ name ] (entries folder);
      Sys.remove (file name))
    [ 200; 235; 251 ]

let large _ file =
  let text = String.init 3_000_000 (fun i -> Char.chr (i land 255)) in
  ok (Output.write (file "a.ppm") text);
  Alcotest.(check bool)
    "every byte" true
    (String.equal text (read (file "a.ppm")))

let suite =
  let example name f = Law.example name (in_folder f) in
  ( "output files",
    [
      example "a file is written whole, new or in place of an old one" whole;
      example "the target changes at the end, and only it" before_and_after;
      example "who reads the old file never sees the new one in it" readers;
      example "discard leaves everything as it was" discarded;
      example "two writers do not mix" two_at_once;
      example "directories and missing folders are refused at once" refused;
      example "so is what may not be written" read_only;
      example "a folder that goes away is an error" gone;
      example
        "a target that cannot be replaced is an error, and nothing is left"
        taken;
      example "a link is followed" link;
      example "a pipe is written to" fifo;
      example "a full device is an error" full;
      example "names may be as long as the system allows" long_names;
      example "a large file is written to the last byte" large;
    ] )
