(* Prints what is wrong with each scene that is named on the command line. *)

open Candor_read

let show path =
  Printf.printf "== %s\n" path;
  match Scene_file.read path with
  | Ok _ -> print_endline "no error"
  | Error report -> Format.printf "%a@?" Error.pp_report report

let () =
  List.tl (Array.to_list Sys.argv)
  |> List.filter (fun path ->
      not (String.equal (Filename.basename (Filename.dirname path)) "parts"))
  |> List.sort String.compare |> List.iter show
