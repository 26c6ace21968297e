open Cmdliner

let run files =
  let failed = List.filter (fun f -> Result.is_error (Settings.read f)) files in
  if failed = [] then Status.Fine else Reported

let files =
  Arg.(
    non_empty & pos_all string []
    & info [] ~docv:"SCENE" ~doc:"The scene files to check.")

let man =
  [
    `S Manpage.s_description;
    `P
      "Reads scenes and says nothing if they are right. Else all errors are \
       printed on standard error, each with its place and a hint.";
  ]

let command =
  Cmd.v
    (Cmd.info "check" ~doc:"read scenes and report all errors" ~man
       ~exits:Status.infos)
    Term.(const run $ files)
