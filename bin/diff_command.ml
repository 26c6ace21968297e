open Cmdliner
open Candor_image

let ( let* ) = Result.bind

let read name =
  let file =
    match In_channel.with_open_bin name In_channel.input_all with
    | text -> Ok text
    | exception Sys_error why -> Error why
  in
  let* text = file in
  Result.map_error (fun why -> name ^ ": " ^ why) (Picture_file.decode text)

let compare a b =
  let* a = read a in
  let* b = read b in
  Comparison.v a b

let run a b as_json threshold =
  match compare a b with
  | Error why -> Status.Wrong why
  | Ok c -> (
      print_string
        (if as_json then Comparison.to_json c ^ "\n" else Comparison.to_text c);
      match threshold with
      | Some e when not (Comparison.within e c) ->
          Missed
            (Printf.sprintf "the RMSE %g is above the threshold %g" c.rmse e)
      | Some _ | None -> Fine)

let file i docv doc =
  Arg.(required & pos i (some string) None & info [] ~docv ~doc)

let a = file 0 "A" "A picture: PPM, PNG or PFM."
let b = file 1 "B" "The reference to compare it with."
let as_json = Arg.(value & flag & info [ "json" ] ~doc:"Print JSON.")

let threshold =
  Arg.(
    value
    & opt (some float) None
    & info [ "threshold" ] ~docv:"E"
        ~doc:"Exit with 3 if the RMSE is above $(docv).")

let man =
  [
    `S Manpage.s_description;
    `P
      "Prints how far picture A is from B: root mean square, mean absolute and \
       greatest error, and the relative mean square. 8-bit files are measured \
       in units of 1/255, PFM files in linear radiance.";
  ]

let command =
  Cmd.v
    (Cmd.info "diff" ~doc:"measure how two pictures differ" ~man
       ~exits:Status.infos)
    Term.(const run $ a $ b $ as_json $ threshold)
