open Candor

(* Looks for the temporary file: when it is there, the render has begun to care
   for files. *)
let rec begun pid =
  let parts =
    List.filter (fun e -> Filename.check_suffix e ".part") (entries ".")
  in
  if parts = [] then (
    (match Unix.waitpid [ WNOHANG ] pid with
    | 0, _ -> ()
    | _, status ->
        Alcotest.failf "it ended with %d before it began" (code status));
    ignore (Unix.select [] [] [] 0.002 : _ * _ * _);
    begun pid)

let interrupted ?(more = []) scene signal =
  let err = fresh () in
  let stderr = to_file err in
  let stdin = null [ O_RDONLY ] and stdout = null [ O_WRONLY ] in
  let pid =
    start ~stdin ~stdout ~stderr
      ([ "render"; scene; "-o"; "a.ppm"; "--stats"; "t.json" ] @ more)
  in
  List.iter Unix.close [ stdin; stdout; stderr ];
  begun pid;
  Unix.kill pid signal;
  let ended = wait pid in
  let said = read err in
  Sys.remove err;
  Alcotest.(check int) ("exit code: " ^ said) 130 ended;
  mentions said "interrupted; a.ppm was not written"

let long = [ "--size=2000x2000"; "--spp=100" ]

let new_target () =
  interrupted ~more:long "s.scene" Sys.sigint;
  check_entries "nothing is left" [ "s.scene" ]

let old_target () =
  write "a.ppm" "old";
  write "t.json" "old";
  interrupted ~more:long "s.scene" Sys.sigint;
  check_text "the old picture" "old" (read "a.ppm");
  check_text "the old statistics" "old" (read "t.json");
  check_entries "nothing else" [ "a.ppm"; "s.scene"; "t.json" ]

let other_signals () =
  List.iter
    (fun signal ->
      interrupted ~more:("--quiet" :: long) "s.scene" signal;
      check_entries "nothing is left" [ "s.scene" ])
    [ Sys.sigterm; Sys.sighup ]

(* The scene is big enough for the signal to come while its tree is built. *)
let while_building () =
  let ball i =
    Printf.sprintf "(sphere (center %d %d %d) (radius .4))\n" (i mod 30)
      (i / 30 mod 30)
      (i / 900)
  in
  write "b.scene"
    ("(scene (camera (perspective (eye 0 1 5) (look-at 0 0 0) (fov-y 40)))\n"
    ^ String.concat "" (List.init 30000 ball)
    ^ ")");
  interrupted ~more:long "b.scene" Sys.sigint;
  check_entries "nothing is left" [ "b.scene"; "s.scene" ]

let suite =
  ( "interrupts",
    [
      with_scene "an interrupted render leaves no file" new_target;
      with_scene "and the old files as they were" old_target;
      with_scene "so do termination and hanging up" other_signals;
      with_scene "and an interrupt before the first ray" while_building;
    ] )
