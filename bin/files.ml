open Candor_render

let ( let* ) = Result.bind
let wrong result = Result.map_error (fun why -> Status.Wrong why) result

(* The first signal asks the rows to stop. *)
let stop_on_signals () =
  let stopped = Atomic.make false in
  let handle = Sys.Signal_handle (fun _ -> Atomic.set stopped true) in
  List.iter (fun s -> Sys.set_signal s handle) Sys.[ sigint; sigterm; sighup ];
  fun () -> Atomic.get stopped

let writing name f =
  let* file = wrong (Output.open_ name) in
  match f file with
  | Ok _ as fine -> fine
  | Error _ as e ->
      Output.discard file;
      e
  | exception e ->
      Output.discard file;
      raise e

let writing_some name f =
  match name with
  | None -> f (fun _ -> Ok ())
  | Some name ->
      writing name (fun file ->
          f (fun text -> wrong (Output.commit file (Lazy.force text))))

(* Only errors of opening name the file. *)
let read name =
  try Ok (In_channel.with_open_bin name In_channel.input_all) with
  | Sys_error why when String.starts_with ~prefix:name why -> Error why
  | Sys_error why -> Error (name ^ ": " ^ why)
