(* Files to read in a folder of their own, gone afterwards. *)

let with_folder f =
  let folder = Filename.temp_dir "candor" "" in
  let remove () =
    Array.iter
      (fun file -> Sys.remove (Filename.concat folder file))
      (Sys.readdir folder);
    Sys.rmdir folder
  in
  Fun.protect ~finally:remove (fun () -> f folder)

let write folder name text =
  let path = Filename.concat folder name in
  Out_channel.with_open_bin path (fun c -> Out_channel.output_string c text);
  path

(* [f path] while another process writes [text] into the pipe [path]. *)
let with_pipe ~text f =
  with_folder (fun folder ->
      let path = Filename.concat folder "pipe" in
      Unix.mkfifo path 0o600;
      let quoted = Filename.quote_command "printf" [ "%s"; text ] in
      let writer =
        Unix.create_process "/bin/sh"
          [| "/bin/sh"; "-c"; quoted ^ " > " ^ Filename.quote path |]
          Unix.stdin Unix.stdout Unix.stderr
      in
      let result = f path in
      ignore (Unix.waitpid [] writer);
      result)
