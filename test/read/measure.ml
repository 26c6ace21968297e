(* How long, and in how much memory, a scene file is read: for a look by hand. *)

open Candor_read

let peak () =
  In_channel.with_open_bin "/proc/self/status" In_channel.input_all
  |> String.split_on_char '\n'
  |> List.find_opt (String.starts_with ~prefix:"VmHWM")

let () =
  Array.iteri
    (fun i path ->
      if i > 0 then (
        let start = Sys.time () in
        (match Scene_file.read path with
        | Ok scene -> Printf.printf "%d surfaces\n" (List.length scene.surfaces)
        | Error report -> Format.printf "%a@?" Error.pp_report report);
        Printf.printf "%s: %.2f s, %s\n" path
          (Sys.time () -. start)
          (Option.value (peak ()) ~default:"")))
    Sys.argv
