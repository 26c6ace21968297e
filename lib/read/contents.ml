let explain = function
  | Unix.ENOENT -> "there is no such file"
  | Unix.EACCES -> "you may not read this file"
  | error ->
      "cannot be read: " ^ String.uncapitalize_ascii (Unix.error_message error)

(* Anything but a regular file could go on forever. *)
let of_file ~what path =
  match
    Unix.access path [ R_OK ];
    (Unix.stat path).st_kind
  with
  | exception Unix.Unix_error (error, _, _) -> Error (explain error)
  | S_DIR -> Error ("this is a folder, not " ^ what)
  | S_CHR | S_BLK | S_LNK | S_FIFO | S_SOCK ->
      Error "this is not a regular file"
  | S_REG -> (
      match In_channel.with_open_bin path In_channel.input_all with
      | text -> Ok text
      | exception Sys_error why -> Error ("cannot be read: " ^ why))
