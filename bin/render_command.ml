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
  crop : Window.t option;
  confidence : float;
  map : string option;
  save_map : string option;
  all_effects : bool;
  math : Candor_surface.Math.t;
  binary : bool;
  stats : string option;
  quiet : bool;
}

let usage why = Error (Status.Usage why)

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
  | None -> Ok (Window.full s)
  | Some { x1; y1; _ } when x1 > s.width || y1 > s.height ->
      usage
        (Printf.sprintf "--crop reaches %d,%d but the picture is %dx%d" x1 y1
           s.width s.height)
  | Some w -> Ok w

(* {1 Numbers of samples} *)

let read_map file =
  Result.bind (Files.read file) (fun text ->
      Result.map_error
        (fun why -> file ^ ": " ^ why)
        (Sample_map.of_string text))

let mapped file (s : Scene.t) window =
  let* map = Files.wrong (read_map file) in
  if Sample_map.(width map <> s.width || height map <> s.height) then
    Error
      (Status.Wrong
         (Printf.sprintf "%s is of a picture of %dx%d, but this one is %dx%d"
            file (Sample_map.width map) (Sample_map.height map) s.width s.height))
  else if not (Sample_map.contains map window) then
    Error (Status.Wrong (file ^ " does not hold all of the crop"))
  else
    (* Nothing of the scene's own says how many samples there are. *)
    let spp = Sample_map.spp map in
    let settings = { s.settings with spp; error = None; time = None } in
    Ok ({ s with settings }, Render.Map map)

(* Seconds that making the picture, writing it and most of its ledger will take:
   a strip of noise tells. *)
let writing_time format ~binary window =
  let height = Window.height window in
  let strip = Int.min 64 height in
  let noise x y =
    Candor_colour.Rgb.grey
      (Candor_sample.Key.float
         (Candor_sample.Key.v ~seed:0 ~x ~y ~sample:0 ~bounce:0 Film))
  in
  let clock = Clock.start () in
  let picture = Picture.init ~width:(Window.width window) ~height:strip noise in
  ignore (Picture_file.encode format ~binary picture : string);
  ignore (Ledger.output picture : Ledger.output);
  Clock.seconds clock *. float_of_int height /. float_of_int strip

(* The scene as it is sampled, and how. *)
let samples o format (s : Scene.t) window =
  let { Scene.spp; error; time; _ } = s.settings in
  match (o.map, error, time) with
  | Some _, _, _ when Settings.choose_samples o.settings ->
      usage
        "--map says how many samples there are: --spp, --error and --time \
         cannot"
  | Some file, _, _ -> mapped file s window
  | None, None, None -> Ok (s, Render.Uniform spp)
  | None, error, time ->
      let left =
        Option.map
          (fun time ->
            let writing = writing_time format ~binary:o.binary window in
            fun () -> time -. Clock.of_program () -. writing)
          time
      in
      let confidence = o.confidence and most = spp in
      Ok (s, Adaptive { error; confidence; left; most })

let trace o ~stop ~samples scene window =
  let plan = Settings.plan ~all_effects:o.all_effects scene in
  let pixel = Pixel.compile ~plan ~math:o.math scene in
  let progress = Progress.make ~quiet:o.quiet in
  let report =
    Render.run ?domains:o.domains ~stop ~progress:(Progress.report progress)
      ~window ~samples pixel scene
  in
  Progress.finish progress;
  Option.map (fun report -> (plan, report)) report

(* A stated error that was not met is told by the ledger, and by the code. *)
let reached (s : Scene.t) (report : Render.report) =
  match (s.settings.error, report.aim) with
  | Some error, Some { ending = Misjudged | Out_of_time | Out_of_samples; _ } ->
      Status.Missed (Printf.sprintf "the error of %g/255 was not reached" error)
  | (Some _ | None), (Some _ | None) -> Status.Fine

let run o =
  let name = target o in
  let* format = format_of name in
  let* scene = Settings.read o.scene in
  let scene = Settings.apply o.settings scene in
  let* window = window o scene in
  let* scene, samples = samples o format scene window in
  (* From here on there are files that an interrupt must not leave behind. *)
  let stop = Files.stop_on_signals () in
  Files.writing name @@ fun file ->
  Files.writing_some o.stats @@ fun write_stats ->
  Files.writing_some o.save_map @@ fun write_map ->
  match trace o ~stop ~samples scene window with
  | None ->
      Error (Status.Interrupted ("interrupted; " ^ name ^ " was not written"))
  | Some (plan, report) ->
      let text = Picture_file.encode format ~binary:o.binary report.picture in
      let* () = Files.wrong (Output.commit file text) in
      let* () =
        write_stats
          (lazy
            (Json.to_string
               (Ledger.json ~confidence:o.confidence scene plan report)))
      in
      let* () = write_map (lazy (Sample_map.to_string report.map)) in
      let warnings = Settings.warnings o.settings plan scene in
      if not o.quiet then
        Status.tell
          (Ledger.text ~name ~format ~confidence:o.confidence ~warnings scene
             report);
      Ok (reached scene report)

(* {1 The command line} *)

let crop =
  let parse s =
    match List.map int_of_string_opt (String.split_on_char ',' s) with
    | [ Some x0; Some y0; Some x1; Some y1 ]
      when 0 <= x0 && x0 < x1 && 0 <= y0 && y0 < y1 ->
        Ok { Window.x0; y0; x1; y1 }
    | _ ->
        Error
          ("'" ^ s
         ^ "': expected X0,Y0,X1,Y1 in pixels from the top left, X0 < X1 and \
            Y0 < Y1")
  in
  let pp ppf { Window.x0; y0; x1; y1 } =
    Format.fprintf ppf "%d,%d,%d,%d" x0 y0 x1 y1
  in
  Arg.Conv.make ~docv:"X0,Y0,X1,Y1" ~parser:parse ~pp ()

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

let confidence =
  let parse s =
    match float_of_string_opt s with
    | Some c when 0. < c && c < 1. -> Ok c
    | Some _ | None ->
        Error ("'" ^ s ^ "': expected a probability between 0 and 1")
  in
  let print ppf = Format.fprintf ppf "%g" in
  Arg.(
    value
    & opt (Conv.make ~docv:"C" ~parser:parse ~pp:print ()) 0.95
    & info [ "confidence" ] ~docv:"C"
        ~doc:
          "How sure the error that $(b,--error) asks for must be met, and the \
           interval of the ledger holds the error.")

let sample_map =
  optional [ "map" ] Arg.string "FILE"
    "Take as many samples of each pixel as $(docv) says, which $(b,--save-map) \
     wrote: the same picture, to the bit."

let save_map =
  optional [ "save-map" ] Arg.string "FILE"
    "Write how many samples each pixel was given to $(docv), as text."

let stats =
  optional [ "stats" ] Arg.string "FILE"
    "Write counts of rays, times and errors to $(docv) as JSON."

let binary =
  Arg.(
    value & flag & info [ "binary" ] ~doc:"Write PPM in its binary form, P6.")

let quiet = Arg.(value & flag & info [ "quiet" ] ~doc:"Say nothing but errors.")

let term =
  let make scene output settings domains crop confidence map save_map
      all_effects math binary stats quiet () =
    let o =
      {
        scene;
        output;
        settings;
        domains;
        crop;
        confidence;
        map;
        save_map;
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
    const make $ Settings.scene $ output $ Settings.with_targets
    $ Settings.domains $ crop $ confidence $ sample_map $ save_map
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
