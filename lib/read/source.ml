type text =
  | Whole of { text : string; mutable read : int }
  | File of { descr : Unix.file_descr }
  | Pipe of { descr : Unix.file_descr; patience : float; heard : Buffer.t }

type t = { name : string; identity : (int * int) option; text : text }

let of_string ~name text =
  { name; identity = None; text = Whole { text; read = 0 } }

let name s = s.name

let same a b =
  match (a.identity, b.identity) with
  | Some (device, file), Some (device', file') ->
      Int.equal device device' && Int.equal file file'
  | None, _ | _, None -> String.equal a.name b.name

let beside s path =
  let folder = Filename.dirname s.name in
  if Filename.is_relative path && not (String.equal folder ".") then
    Filename.concat folder path
  else path

let explain = function
  | Unix.ENOENT -> "there is no such file"
  | Unix.EACCES -> "you may not read this file"
  | error ->
      "cannot be read: " ^ String.uncapitalize_ascii (Unix.error_message error)

let rec retry f =
  match f () with
  | value -> Ok value
  | exception Unix.Unix_error (Unix.EINTR, _, _) -> retry f
  | exception Unix.Unix_error (error, _, _) -> Error (explain error)

(* Without O_NONBLOCK, opening a pipe waits until somebody writes to it. *)
let open_descr path =
  if String.contains path '\000' then Error (explain Unix.ENOENT)
  else
    retry (fun () -> Unix.openfile path [ O_RDONLY; O_NONBLOCK; O_CLOEXEC ] 0)

let close_descr descr = ignore (retry (fun () -> Unix.close descr))

let open_file ?(patience = 5.) path =
  let ( let* ) = Result.bind in
  let* descr = open_descr path in
  let* stats = retry (fun () -> Unix.fstat descr) in
  let source text =
    Ok { name = path; identity = Some (stats.st_dev, stats.st_ino); text }
  in
  match stats.st_kind with
  | S_REG -> source (File { descr })
  | S_DIR ->
      close_descr descr;
      Error "this is a folder, not a scene"
  | S_CHR | S_BLK | S_LNK | S_FIFO | S_SOCK ->
      source (Pipe { descr; patience; heard = Buffer.create 4096 })

let close s =
  match s.text with
  | Whole _ -> ()
  | File { descr } | Pipe { descr; _ } -> close_descr descr

let read descr buffer =
  retry (fun () -> Unix.read descr buffer 0 (Bytes.length buffer))

let listen descr patience =
  match retry (fun () -> Unix.select [ descr ] [] [] patience) with
  | Ok ([], _, _) ->
      Error (Printf.sprintf "nothing came through this pipe for %g s" patience)
  | Ok (_ :: _, _, _) -> Ok ()
  | Error _ as e -> e

let input s buffer =
  match s.text with
  | Whole w ->
      let n = Int.min (Bytes.length buffer) (String.length w.text - w.read) in
      Bytes.blit_string w.text w.read buffer 0 n;
      w.read <- w.read + n;
      Ok n
  | File { descr } -> read descr buffer
  | Pipe { descr; patience; heard } ->
      let heard n =
        Buffer.add_subbytes heard buffer 0 n;
        n
      in
      Result.bind (listen descr patience) (fun () -> read descr buffer)
      |> Result.map heard

let reread path ~first ~length =
  match open_file path with
  | Error _ | Ok { text = Whole _; _ } -> ""
  | Ok ({ text = Pipe _; _ } as s) ->
      close s;
      ""
  | Ok ({ text = File { descr }; _ } as s) ->
      let buffer = Bytes.create length in
      let found =
        let ( let* ) = Result.bind in
        let* (_ : int) = retry (fun () -> Unix.lseek descr first SEEK_SET) in
        read descr buffer
      in
      close s;
      Bytes.sub_string buffer 0 (Result.value found ~default:0)

let most = 65536

let slice s ~first ~last =
  let within size =
    let first = Int.max 0 (Int.min first size) in
    (first, Int.max 0 (Int.min most (Int.min last size - first)))
  in
  match s.text with
  | Whole { text; _ } ->
      let first, length = within (String.length text) in
      String.sub text first length
  | Pipe { heard; _ } ->
      let first, length = within (Buffer.length heard) in
      Buffer.sub heard first length
  | File _ ->
      let first, length = within max_int in
      reread s.name ~first ~length
