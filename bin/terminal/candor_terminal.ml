(* Help and usage are paged and styled for terminals only. Cmdliner decides that
   by TERM when it is initialised: bin/dune lists this library first, so that it
   comes before. *)
let () =
  if not (Unix.isatty Unix.stderr && Unix.isatty Unix.stdout) then
    Unix.putenv "TERM" "dumb"
