(* What renders say of their errors, beside what these errors are. *)

(* A target is this share of the error that 16 samples a pixel leave. *)
let target_share = 0.7
let confidences = [ 0.68; 0.95 ]

(* The true picture has 64 times as many samples as any that is judged: half of
   them in each half. Those that seek a target take about 32 for each pixel. *)
let true_spp (case : Case.t) = 32 * List.fold_left Int.max 32 case.spp

let of_case case =
  let truth = Truth.v case.Case.scene ~spp:(true_spp case) in
  let coverage = List.map (Coverage.v truth case) case.spp in
  let error = target_share *. Coverage.error (List.hd coverage) in
  let aim confidence = Aim.v truth case ~error ~confidence in
  (coverage, List.map aim confidences)

let measure () =
  let coverage, aims = List.split (List.map of_case (Case.all ())) in
  let coverage = List.concat coverage and aims = List.concat aims in
  let blocks =
    [
      ("coverage", Figures.coverage coverage);
      ("targets", Figures.aims confidences aims);
      ("forecasts", Figures.forecasts aims);
      ("bias", Figures.bias (Bias.all ()));
    ]
  in
  (blocks, Plot.svg coverage)

let lines file = In_channel.with_open_bin file In_channel.input_lines

let write file text =
  Out_channel.with_open_bin file (fun c -> output_string c text)

let () =
  match Sys.argv with
  | [| _; "measure"; figures; plot |] ->
      let blocks, svg = measure () in
      let lines = List.concat_map Page.block blocks in
      write figures (String.concat "\n" lines ^ "\n");
      write plot svg
  | [| _; "page"; page; figures |] ->
      Page.fill (Page.blocks (lines figures)) (lines page)
      |> List.iter print_endline
  | _ ->
      prerr_endline
        "usage: calibration measure FIGURES PLOT | page PAGE FIGURES";
      exit 2
