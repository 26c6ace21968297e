open Cmdliner
open Candor_render
open Candor_cost

let ( let* ) = Result.bind

type options = {
  scene : string;
  settings : Settings.t;
  seconds : float;
  domains : int option;
  csv : string option;
  html : string option;
  quiet : bool;
}

let survey o ~domains ~budget ~stop scene =
  let progress = Progress.make ~quiet:o.quiet in
  let progress_of share = Progress.report progress (Pace.sure share) in
  let found =
    Survey.run { scene; domains; budget; stop; progress = progress_of }
  in
  Progress.finish progress;
  found

let talk o (prices : Price.t) missing =
  if not o.quiet then (
    Status.tell
      (Printf.sprintf "%s: %d of %d pixels in %s of %s" o.scene prices.pixels
         (prices.width * prices.height)
         (Progress.time prices.spent)
         (Progress.time prices.budget));
    match
      List.map (fun v -> Price_text.setting (Variant.setting v)) missing
    with
    | [] -> ()
    | _ :: _ as names ->
        Status.tell
          ("no time was left for: " ^ String.concat ", " names
         ^ " (a greater --budget helps)"))

let run o =
  let budget = Budget.start o.seconds in
  let* scene = Settings.read o.scene in
  let scene = Settings.apply o.settings scene in
  let stop = Files.stop_on_signals () in
  Files.writing_some o.csv @@ fun write_csv ->
  Files.writing_some o.html @@ fun write_html ->
  let domains = Option.value o.domains ~default:(Rows.most_domains ()) in
  match survey o ~domains ~budget ~stop scene with
  | None -> Error (Status.Interrupted "interrupted; nothing was written")
  | Some survey ->
      let prices = Appraisal.v scene ~file:o.scene ~domains budget survey in
      let* () = write_csv (lazy (Price_text.csv prices)) in
      let* () = write_html (lazy (Page.html prices)) in
      talk o prices survey.missing;
      print_string (Price_text.table scene prices);
      Ok Status.Fine

(* {1 The command line} *)

let seconds =
  Arg.(
    value & opt Settings.duration 20.
    & info [ "budget" ] ~docv:"T"
        ~doc:
          "How long it may take, such as $(b,20s) or $(b,5m). The more, the \
           more pixels and samples the prices are made from.")

let csv =
  Arg.(
    value
    & opt (some string) None
    & info [ "csv" ] ~docv:"FILE"
        ~doc:"Write all rows to $(docv) as comma-separated values.")

let html =
  Arg.(
    value
    & opt (some string) None
    & info [ "html" ] ~docv:"FILE"
        ~doc:"Write a page with plots and pictures to $(docv).")

let quiet =
  Arg.(value & flag & info [ "quiet" ] ~doc:"Say nothing but the list.")

let term =
  let make scene settings seconds domains csv html quiet =
    match run { scene; settings; seconds; domains; csv; html; quiet } with
    | Ok status | Error status -> status
  in
  Term.(
    const make $ Settings.scene $ Settings.term $ seconds $ Settings.domains
    $ csv $ html $ quiet)

let man =
  [
    `S Manpage.s_description;
    `P
      "Prints what accuracy costs in time: seconds beside errors of the \
       picture, for more and more samples, and for every other setting, light \
       and effect that the scene has. Within its budget it renders a part of \
       the pixels only; seconds are those of the whole picture, errors the \
       root mean square of the displayed picture's in units of 1/255.";
    `P
      "$(b,*) marks rows that no other beats, $(b,<- knee) the number of \
       samples after which more of them bring little. Below stand the law that \
       the errors follow and the time that it takes to bring them down.";
    `S Manpage.s_examples;
    `Pre "  candor cost scenes/hero.scene";
    `Pre "  candor cost scenes/cornell.scene --budget 1m --csv prices.csv";
  ]

let command =
  Cmd.v
    (Cmd.info "cost" ~doc:"print what accuracy costs in time" ~man
       ~exits:Status.infos)
    term
