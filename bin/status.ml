type t =
  | Fine
  | Wrong of string
  | Reported
  | Usage of string
  | Missed of string
  | Interrupted of string

(* There is nowhere to report that standard error cannot be written. *)
let tell text = try Printf.eprintf "%s\n%!" text with Sys_error _ -> ()
let say text = tell ("candor: " ^ text)

let code = function
  | Fine -> 0
  | Reported -> 1
  | Wrong why ->
      say why;
      1
  | Usage why ->
      say why;
      2
  | Missed why ->
      say why;
      3
  | Interrupted what ->
      say what;
      130

let infos =
  let info code doc = Cmdliner.Cmd.Exit.info code ~doc in
  [
    info 0 "when all is well.";
    info 1 "when the scene, an input or an output is wrong.";
    info 2 "when the command line is.";
    info 3 "when a stated target was not met.";
    info 130 "when interrupted; nothing is written then.";
  ]
