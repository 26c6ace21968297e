(** The executable, run as a user would run it. *)

let program =
  let here = Filename.dirname Sys.executable_name in
  let here =
    if Filename.is_relative here then Filename.concat (Sys.getcwd ()) here
    else here
  in
  Filename.concat here "../../bin/main.exe"

let read name = In_channel.with_open_bin name In_channel.input_all

let write name text =
  Out_channel.with_open_bin name (fun c -> Out_channel.output_string c text)

let entries folder =
  List.sort String.compare (Array.to_list (Sys.readdir folder))

let rec remove name =
  match (Unix.lstat name).st_kind with
  | S_DIR ->
      List.iter (fun e -> remove (Filename.concat name e)) (entries name);
      Unix.rmdir name
  | _ -> Unix.unlink name

(** [here f] is a test that runs [f] in an empty folder of its own. *)
let here f () =
  let home = Sys.getcwd () in
  let folder = Filename.temp_dir "candor" "command" in
  Sys.chdir folder;
  Fun.protect f ~finally:(fun () ->
      Sys.chdir home;
      remove folder)

let example name f = Candor_oracle.Law.example name (here f)

type ended = { code : int; out : string; err : string }

(* What a shell shows: 128 more than the signal that killed it. *)
let code = function
  | Unix.WEXITED n -> n
  | WSIGNALED s | WSTOPPED s -> 1000 + abs s

let rec wait pid =
  match Unix.waitpid [] pid with
  | _, status -> code status
  | exception Unix.Unix_error (EINTR, _, _) -> wait pid

let null flags = Unix.openfile "/dev/null" flags 0
let fresh () = Filename.temp_file "candor" "said"
let to_file name = Unix.openfile name [ O_WRONLY; O_TRUNC; O_CLOEXEC ] 0

(* A child inherits what is ignored here. *)
let with_default_signals f =
  let old =
    List.map
      (fun s -> (s, Sys.signal s Signal_default))
      Sys.[ sigpipe; sigxfsz ]
  in
  Fun.protect f ~finally:(fun () ->
      List.iter (fun (s, b) -> Sys.set_signal s b) old)

(** [start program args ~stdin ~stdout ~stderr] is the process of [program]. *)
let start ?(program = program) ?(env = [||]) ~stdin ~stdout ~stderr args =
  let env = Array.append env (Unix.environment ()) in
  with_default_signals (fun () ->
      Unix.create_process_env program
        (Array.of_list (program :: args))
        env stdin stdout stderr)

let run_program program ?(input = "") ?env args =
  let given = fresh () and out = fresh () and err = fresh () in
  write given input;
  let stdin = Unix.openfile given [ O_RDONLY; O_CLOEXEC ] 0 in
  let stdout = to_file out and stderr = to_file err in
  let pid = start ~program ?env ~stdin ~stdout ~stderr args in
  List.iter Unix.close [ stdin; stdout; stderr ];
  let code = wait pid in
  let result = { code; out = read out; err = read err } in
  List.iter Sys.remove [ given; out; err ];
  result

(** [run args] is how [candor args] ended and what it said. *)
let run ?input ?env args = run_program program ?input ?env args

(** [shell script] runs [script] with the program as [$CANDOR]. *)
let shell script =
  run_program "/bin/sh" ~env:[| "CANDOR=" ^ program |] [ "-c"; script ]

(** {1 Expectations} *)

let contains text part =
  let n = String.length part in
  let rec from i =
    i + n <= String.length text && (String.sub text i n = part || from (i + 1))
  in
  from 0

let mentions text part =
  if not (contains text part) then
    Alcotest.failf "expected %S in:\n%s" part text

let code_is name expected r =
  if r.code <> expected then
    Alcotest.failf "%s: exit code %d, expected %d\n%s%s" name r.code expected
      r.out r.err

(** [fails code part args]: [candor args] ends with [code], says [part] on
    standard error, and neither a stack trace nor anything on standard output.
*)
let fails ?input code part args =
  let r = run ?input args in
  let name = String.concat " " args in
  code_is name code r;
  mentions r.err part;
  Alcotest.(check string) (name ^ ": standard output") "" r.out;
  if contains r.err "Raised at" || contains r.err "internal error" then
    Alcotest.failf "%s: %s" name r.err

(** [fine args] is what [candor args] prints. *)
let fine ?input args =
  let r = run ?input args in
  code_is (String.concat " " args) 0 r;
  r

let check_entries name expected =
  Alcotest.(check (list string))
    name
    (List.sort String.compare expected)
    (entries ".")

let check_text name = Alcotest.(check string) name

(** {1 A scene} *)

let scene =
  {|; A glazed ball on a mirror, two lights.
(scene
  (image (size 24 18))
  (camera (perspective (eye 0 1 5) (look-at 0 .5 0) (fov-y 40)))
  (background (gradient (down (rgb .9 .9 .9)) (up (rgb .2 .4 .9))))
  (ambient .05)
  (render (spp 4))
  (light (point (at 5 8 5) (intensity (rgb 300 250 200))))
  (light (directional (direction 1 -1 0) (irradiance .5) (shadows no)))
  (sphere (center 0 .6 0) (radius .6) (material (glazed (color (rgb .7 .2 .2)) (mirror .2))))
  (quadric (plane (normal 0 1 0) (offset 0)) (material (mirror (color .5)))))
|}

(** [with_scene f] is a test with [scene] in [s.scene]. *)
let with_scene name f =
  example name (fun () ->
      write "s.scene" scene;
      f ())
