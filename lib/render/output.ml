type t =
  | Direct of { channel : Unix.file_descr; name : string }
  | Beside of { temporary : string; target : string; name : string }

let explain name = function
  | Unix.Unix_error (e, _, _) ->
      Printf.sprintf "%s: cannot write: %s" name
        (String.lowercase_ascii (Unix.error_message e))
  | Sys_error why -> Printf.sprintf "%s: cannot write: %s" name why
  | e -> raise e

let guard name f =
  match f () with
  | x -> Ok x
  | exception ((Unix.Unix_error _ | Sys_error _) as e) -> Error (explain name e)

(* As much of the target's name as leaves room for the rest, so that the longest
   name a system allows can be written. *)
let stem base = String.sub base 0 (Int.min 100 (String.length base))

let rec create directory base n =
  let temporary =
    Filename.concat directory
      (Printf.sprintf ".%s.%d.%d.part" (stem base) (Unix.getpid ()) n)
  in
  match
    Unix.openfile temporary [ O_WRONLY; O_CREAT; O_EXCL; O_CLOEXEC ] 0o666
  with
  | fd ->
      Unix.close fd;
      temporary
  | exception Unix.Unix_error (EEXIST, _, _) when n < 100 ->
      create directory base (n + 1)

let beside name target =
  let directory = Filename.dirname target and base = Filename.basename target in
  guard name (fun () ->
      Beside { temporary = create directory base 0; target; name })

let open_ name =
  if name = "-" then
    Ok (Direct { channel = Unix.stdout; name = "standard output" })
  else
    match (Unix.stat name).st_kind with
    | S_DIR -> Error (name ^ ": cannot write: it is a directory")
    | S_REG ->
        (* A read-only file is not replaced behind its owner's back. *)
        Result.bind
          (guard name (fun () ->
               Unix.access name [ W_OK ];
               Unix.realpath name))
          (beside name)
    | S_CHR | S_BLK | S_FIFO | S_SOCK | S_LNK ->
        guard name (fun () ->
            Direct
              { channel = Unix.openfile name [ O_WRONLY; O_CLOEXEC ] 0; name })
    | exception Unix.Unix_error (ENOENT, _, _) -> beside name name
    | exception (Unix.Unix_error _ as e) -> Error (explain name e)

let write_all fd text =
  let rec go from =
    if from < String.length text then
      match Unix.write_substring fd text from (String.length text - from) with
      | n -> go (from + n)
      | exception Unix.Unix_error (EINTR, _, _) -> go from
  in
  go 0

let discard = function
  | Direct _ -> ()
  | Beside { temporary; _ } -> (
      try Unix.unlink temporary with Unix.Unix_error _ -> ())

let commit file text =
  match file with
  | Direct { channel; name } -> guard name (fun () -> write_all channel text)
  | Beside { temporary; target; name } ->
      let written =
        guard name (fun () ->
            let fd = Unix.openfile temporary [ O_WRONLY; O_CLOEXEC ] 0 in
            Fun.protect
              ~finally:(fun () -> Unix.close fd)
              (fun () -> write_all fd text);
            Unix.rename temporary target)
      in
      if Result.is_error written then discard file;
      written

let write name text = Result.bind (open_ name) (fun file -> commit file text)
