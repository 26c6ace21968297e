(* candor: the command line. *)

open Cmdliner

let man =
  [
    `S Manpage.s_description;
    `P
      "Candor renders scenes written as s-expressions. It says what accuracy \
       costs in time, keeps hard cases numerically stable, and simulates only \
       the effects that a scene calls for.";
    `S Manpage.s_examples;
    `Pre "  candor render scenes/glazed-floor.scene -o floor.png";
    `Pre "  candor explain scenes/glazed-floor.scene";
    `Pre "  candor trace scenes/glazed-floor.scene 320 240";
  ]

let version = "0.1.0"

let command =
  Cmd.group
    (Cmd.info "candor" ~version ~man ~exits:Status.infos
       ~doc:"a ray tracer that is honest about its pictures")
    ([
       Render_command.command;
       Check_command.command;
       Explain_command.command;
       Cost_command.command;
       Trace_command.command;
       Cast_command.command;
       Diff_command.command;
     ]
    @ Refused.commands)

let evaluate () =
  match Cmd.eval_value ~catch:false command with
  | Ok (`Ok status) -> Status.code status
  | Ok (`Help | `Version) -> 0
  | Error (`Parse | `Term | `Exn) -> 2

let internal e =
  Status.Wrong
    (Printf.sprintf
       "internal error: %s. This is a fault of Candor: please report it with \
        the scene."
       (Printexc.to_string e))

(* What goes wrong with standard output is an error like any other. *)
let guarded f =
  match f () with
  | code -> code
  | exception Out_of_memory -> Status.code (Wrong "not enough memory")
  | exception Stack_overflow -> Status.code (Wrong "the scene nests too deeply")
  | exception Sys_error why -> Status.code (Wrong why)
  | exception Unix.Unix_error (e, _, _) ->
      Status.code (Wrong (String.lowercase_ascii (Unix.error_message e)))
  | exception e -> Status.code (internal e)

let () =
  (* A reader that goes away and a file-size limit are errors to report, not
     reasons to die. *)
  Sys.set_signal Sys.sigpipe Signal_ignore;
  Sys.set_signal Sys.sigxfsz Signal_ignore;
  let code = guarded evaluate in
  let flushed =
    guarded (fun () ->
        Format.pp_print_flush Format.std_formatter ();
        flush stdout;
        0)
  in
  Unix._exit (if code = 0 then flushed else code)
