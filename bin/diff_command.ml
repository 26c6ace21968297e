open Cmdliner
open Candor_image

let ( let* ) = Result.bind

let read name =
  let* text = Files.read name in
  Result.map_error (fun why -> name ^ ": " ^ why) (Picture_file.decode text)

type options = {
  as_json : bool;
  threshold : float option;
  ppd : float;
  heatmap : string option;
}

let wrong result = Result.map_error (fun why -> Status.Wrong why) result

let compare ~ppd a b =
  let* a = read a in
  let* b = read b in
  let* c = Comparison.v a b in
  let* flip = Flip.v ~ppd a b in
  Ok (c, flip)

(* Where the heat map goes is looked at before there is one to write. *)
let heatmap_format name =
  Result.map_error
    (fun why -> Status.Usage why)
    (Picture_file.format_of_name name)

let write_heatmap name format flip =
  let picture = Flip.heatmap format flip in
  wrong
    (Candor_render.Output.write name
       (Picture_file.encode format ~binary:true picture))

let print o c flip =
  print_string
    (if o.as_json then
       let also = [ ("flip", Flip.mean flip); ("ppd", Flip.ppd flip) ] in
       Comparison.to_json ~also c ^ "\n"
     else Comparison.to_text c ^ Flip.to_text flip)

let judge o (c : Comparison.t) =
  match o.threshold with
  | Some e when not (Comparison.within e c) ->
      Status.Missed
        (Printf.sprintf "the RMSE %g is above the threshold %g" c.rmse e)
  | Some _ | None -> Fine

let measure o a b write =
  let* c, flip = wrong (compare ~ppd:o.ppd a b) in
  let* () = write flip in
  print o c flip;
  Ok (judge o c)

let run o a b =
  match o.heatmap with
  | None -> measure o a b (fun _ -> Ok ())
  | Some name ->
      let* format = heatmap_format name in
      measure o a b (write_heatmap name format)

(* {1 The command line} *)

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

let ppd =
  let least, most = Flip.ppd_range in
  let parse s =
    match float_of_string_opt s with
    | Some n when n >= least && n <= most -> Ok n
    | Some _ | None ->
        Error
          (Printf.sprintf "'%s': expected a number from %g to %g" s least most)
  in
  let pp ppf n = Format.fprintf ppf "%.4g" n in
  Arg.(
    value
    & opt (Conv.make ~docv:"N" ~parser:parse ~pp ()) Flip.default_ppd
    & info [ "ppd" ] ~docv:"N"
        ~doc:
          "Pixels per degree of visual angle, for FLIP: how large the pictures \
           are seen. Without it, a display 0.7 m wide of 3840 pixels from 0.7 \
           m away.")

let heatmap =
  Arg.(
    value
    & opt (some string) None
    & info [ "heatmap" ] ~docv:"FILE"
        ~doc:
          "Write FLIP's difference in every pixel to $(docv): as colours from \
           black (none) to pale yellow (the greatest) to a $(b,.png) or \
           $(b,.ppm), as the values themselves, 0 to 1, to a $(b,.pfm). The \
           file is written beside its target and renamed.")

let term =
  let make as_json threshold ppd heatmap a b =
    match run { as_json; threshold; ppd; heatmap } a b with
    | Ok status | Error status -> status
  in
  Term.(const make $ as_json $ threshold $ ppd $ heatmap $ a $ b)

let man =
  [
    `S Manpage.s_description;
    `P
      "Prints how far picture A is from B: root mean square, mean absolute and \
       greatest error, and the relative mean square. 8-bit files are measured \
       in units of 1/255, PFM files in linear radiance.";
    `P
      "Then it prints how different they look, as the mean of FLIP (P. \
       Andersson and others, HPG 2020): 0 where nobody sees a difference, 1 \
       for the greatest. The numbers of 8-bit files are shown on an sRGB \
       display; PFM files as Candor displays them, where what is brighter than \
       white is white.";
    `S Manpage.s_examples;
    `Pre "  candor diff mine.png reference.png --heatmap where.png";
    `Pre "  candor diff mine.pfm reference.pfm --threshold 0.01 --json";
  ]

let command =
  Cmd.v
    (Cmd.info "diff" ~doc:"measure how two pictures differ" ~man
       ~exits:Status.infos)
    term
