open Candor_render
open Candor_oracle

let time () =
  List.iter
    (fun (s, expected) ->
      Alcotest.(check string) (string_of_float s) expected (Progress.time s))
    [
      (0., "0.0 s");
      (3.42, "3.4 s");
      (9.94, "9.9 s");
      (9.96, "10 s");
      (10., "10 s");
      (59.4, "59 s");
      (59.6, "1 min 0 s");
      (60., "1 min 0 s");
      (312., "5 min 12 s");
      (3599.4, "59 min 59 s");
      (3599.6, "1 h 0 min");
      (3661., "1 h 1 min");
      (86400., "24 h 0 min");
    ]

(* What is said on standard error while [f] runs. *)
let said f =
  let file = Filename.temp_file "candor" "stderr" in
  flush stderr;
  let saved = Unix.dup Unix.stderr in
  let fd = Unix.openfile file [ O_WRONLY; O_TRUNC ] 0 in
  Unix.dup2 fd Unix.stderr;
  Unix.close fd;
  let restore () =
    flush stderr;
    Unix.dup2 saved Unix.stderr;
    Unix.close saved
  in
  Fun.protect f ~finally:restore;
  let text = In_channel.with_open_bin file In_channel.input_all in
  Sys.remove file;
  text

let speak ~quiet () =
  let p = Progress.make ~quiet in
  for i = 1 to 1000 do
    Progress.report p (Pace.sure (float_of_int i /. 1000.))
  done;
  Progress.finish p

let quiet () =
  Alcotest.(check string) "quiet" "" (said (speak ~quiet:true));
  Alcotest.(check string)
    "not a terminal, soon done" ""
    (said (speak ~quiet:false))

let suite =
  ( "progress",
    [
      Law.example "times are short and round well" time;
      Law.example
        "nothing is said when quiet, or in the first seconds off a terminal"
        quiet;
    ] )
