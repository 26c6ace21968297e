open Cmdliner
open Candor_scene
open Candor_image
open Candor_render
open Candor_trace

let ( let* ) = Result.bind

type options = {
  scene : string;
  output : string option;
  settings : Settings.t;
  domains : int option;
  crop : Render.window option;
  all_effects : bool;
  math : Candor_surface.Math.t;
  binary : bool;
  stats : string option;
  quiet : bool;
}

let usage why = Error (Status.Usage why)
let wrong result = Result.map_error (fun why -> Status.Wrong why) result

let target o =
  match o.output with
  | Some name -> name
  | None -> Filename.(remove_extension (basename o.scene)) ^ ".ppm"

let format_of name =
  if name = "-" then Ok Picture_file.Ppm
  else
    Result.map_error
      (fun why -> Status.Usage why)
      (Picture_file.format_of_name name)

let window o (s : Scene.t) =
  match o.crop with
  | None -> Ok (Render.full s)
  | Some { x1; y1; _ } when x1 > s.width || y1 > s.height ->
      usage
        (Printf.sprintf "--crop reaches %d,%d but the picture is %dx%d" x1 y1
           s.width s.height)
  | Some w -> Ok w

(* The first signal asks the rows to stop; files are left as they were. *)
let stop_on_signals () =
  let stopped = Atomic.make false in
  let handle = Sys.Signal_handle (fun _ -> Atomic.set stopped true) in
  List.iter (fun s -> Sys.set_signal s handle) Sys.[ sigint; sigterm; sighup ];
  fun () -> Atomic.get stopped

(* [writing name f] is [f file]. Unless that ends well, for whatever reason,
   nothing is left of [file]. *)
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

let writing_stats name f =
  match name with
  | None -> f (fun _ -> Ok ())
  | Some name ->
      writing name (fun file ->
          f (fun json -> wrong (Output.commit file (Json.to_string json))))

let trace o ~stop scene window =
  let plan = Settings.plan ~all_effects:o.all_effects scene in
  let pixel = Pixel.compile ~plan ~math:o.math scene in
  let progress = Progress.make ~quiet:o.quiet in
  let report =
    Render.run ?domains:o.domains ~stop ~progress:(Progress.report progress)
      ~window pixel scene
  in
  Progress.finish progress;
  Option.map (fun report -> (plan, report)) report

let run o =
  let name = target o in
  let* format = format_of name in
  let* scene = Settings.read o.scene in
  let scene = Settings.apply o.settings scene in
  let* window = window o scene in
  (* From here on there are files that an interrupt must not leave behind. *)
  let stop = stop_on_signals () in
  writing name @@ fun file ->
  writing_stats o.stats @@ fun write_stats ->
  match trace o ~stop scene window with
  | None ->
      Error (Status.Interrupted ("interrupted; " ^ name ^ " was not written"))
  | Some (plan, report) ->
      let text = Picture_file.encode format ~binary:o.binary report.picture in
      let* () = wrong (Output.commit file text) in
      let* () = write_stats (Ledger.json scene plan report) in
      let warnings = Settings.warnings o.settings plan scene in
      if not o.quiet then
        Status.tell (Ledger.text ~name ~format ~warnings scene report);
      Ok Status.Fine

(* {1 The command line} *)

let crop =
  let parse s =
    match List.map int_of_string_opt (String.split_on_char ',' s) with
    | [ Some x0; Some y0; Some x1; Some y1 ]
      when 0 <= x0 && x0 < x1 && 0 <= y0 && y0 < y1 ->
        Ok { Render.x0; y0; x1; y1 }
    | _ ->
        Error
          ("'" ^ s
         ^ "': expected X0,Y0,X1,Y1 in pixels from the top left, X0 < X1 and \
            Y0 < Y1")
  in
  let pp ppf { Render.x0; y0; x1; y1 } =
    Format.fprintf ppf "%d,%d,%d,%d" x0 y0 x1 y1
  in
  Arg.Conv.make ~docv:"X0,Y0,X1,Y1" ~parser:parse ~pp ()

let domains =
  let parse s =
    match int_of_string_opt s with
    | Some n when n >= 1 && n <= 128 -> Ok n
    | Some _ | None -> Error ("'" ^ s ^ "': expected a number from 1 to 128")
  in
  Arg.Conv.make ~docv:"N" ~parser:parse ~pp:Format.pp_print_int ()

let optional names kind docv doc =
  Arg.(value & opt (some kind) None & info names ~docv ~doc)

let output =
  optional [ "o"; "output" ] Arg.string "FILE"
    "Where the picture goes: $(b,.ppm) (text, encoded for a display as smallpt \
     does), $(b,.png), or $(b,.pfm) (linear radiance); $(b,-) is PPM on \
     standard output. The default is the scene's name with .ppm, in the \
     current folder. The file is written beside its target and renamed."

let crop =
  optional [ "crop" ] crop "X0,Y0,X1,Y1"
    "Render only this window of the picture, upper bounds exclusive; its \
     pixels are exactly those of the full picture."

let domains =
  optional [ "j" ] domains "N"
    "How many domains (cores) work at once; default all. The picture does not \
     depend on it."

let stats =
  optional [ "stats" ] Arg.string "FILE"
    "Write counts of rays, times and errors to $(docv) as JSON."

let binary =
  Arg.(
    value & flag & info [ "binary" ] ~doc:"Write PPM in its binary form, P6.")

let quiet = Arg.(value & flag & info [ "quiet" ] ~doc:"Say nothing but errors.")

let term =
  let make scene output settings domains crop all_effects math binary stats
      quiet () =
    let o =
      {
        scene;
        output;
        settings;
        domains;
        crop;
        all_effects;
        math;
        binary;
        stats;
        quiet;
      }
    in
    match run o with Ok status | Error status -> status
  in
  Term.(
    const make $ Settings.scene $ output $ Settings.term $ domains $ crop
    $ Settings.all_effects $ Settings.math $ binary $ stats $ quiet
    $ Refused.options)

let man =
  [
    `S Manpage.s_description;
    `P
      "Renders a scene to a picture. Every render ends with a ledger on \
       standard error that says what it cost and what errors it made.";
    `S Manpage.s_examples;
    `Pre "  candor render scenes/glazed-floor.scene -o floor.png";
    `Pre "  candor render scenes/cornell-box.scene --size 160x120 --spp 4";
    `Pre "  candor render scenes/one-sphere.scene -o - | display";
  ]

let command =
  Cmd.v
    (Cmd.info "render" ~doc:"render a scene to a picture" ~man
       ~exits:Status.infos)
    term
