(* Scenes for the benchmark. *)

let scene file =
  match Candor_read.Scene_file.read file with
  | Ok scene -> scene
  | Error report ->
      Format.eprintf "%a%!" Candor_read.Error.pp_report report;
      exit 1

let named folder name = scene (Filename.concat folder (name ^ ".scene"))

let timed f =
  let start = Unix.gettimeofday () in
  let x = f () in
  (x, Unix.gettimeofday () -. start)
