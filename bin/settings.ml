open Cmdliner
open Candor_scene

type t = {
  size : (int * int) option;
  spp : int option;
  depth : int option;
  cutoff : float option;
  seed : int option;
  filter : Scene.filter option;
  error : float option;
  time : float option;
}

(* {1 Converters} *)

let conv ~docv parse print =
  Arg.Conv.make ~docv
    ~parser:(fun s ->
      Result.map_error (fun why -> "'" ^ s ^ "': " ^ why) (parse s))
    ~pp:(fun ppf x -> Format.pp_print_string ppf (print x))
    ()

let whole ~docv ~least =
  let parse s =
    match int_of_string_opt s with
    | Some n when n >= least -> Ok n
    | Some _ | None ->
        Error (Printf.sprintf "expected a whole number, at least %d" least)
  in
  conv ~docv parse string_of_int

let most_pixels = 65536

let size =
  let parse s =
    match List.map int_of_string_opt (String.split_on_char 'x' s) with
    | [ Some w; Some h ]
      when w >= 1 && h >= 1 && w <= most_pixels && h <= most_pixels ->
        Ok (w, h)
    | _ ->
        Error
          (Printf.sprintf "expected WIDTHxHEIGHT such as 640x480, up to %d each"
             most_pixels)
  in
  conv ~docv:"WxH" parse (fun (w, h) -> Printf.sprintf "%dx%d" w h)

let weight =
  let parse s =
    match float_of_string_opt s with
    | Some w when w >= 0. && Float.is_finite w -> Ok w
    | Some _ | None -> Error "expected a number, at least 0"
  in
  conv ~docv:"W" parse (Printf.sprintf "%g")

let error =
  let parse s =
    match float_of_string_opt s with
    | Some e when e > 0. && Float.is_finite e -> Ok e
    | Some _ | None -> Error "expected an error above 0, in units of 1/255"
  in
  conv ~docv:"E" parse (Printf.sprintf "%g")

let duration =
  conv ~docv:"T" Candor_read.Duration.of_string (Printf.sprintf "%gs")

let filter = Arg.enum [ ("box", (Box : Scene.filter)); ("tent", Tent) ]

(* {1 Options} *)

let option names kind docv doc =
  Arg.(value & opt (some kind) None & info names ~docv ~doc)

let size = option [ "size" ] size "WxH" "Size of the picture in pixels."

let spp =
  option [ "spp" ] (whole ~docv:"N" ~least:1) "N"
    "Samples per pixel. One sample is taken at the pixel's centre. Beside \
     $(b,--error) or $(b,--time), the most per pixel."

let depth =
  option [ "depth" ] (whole ~docv:"N" ~least:0) "N"
    "The most reflections, refractions and bounces along one path; 0 shows the \
     first hit with its lights."

let cutoff =
  option [ "cutoff" ] weight "W"
    "Paths whose largest throughput component falls below $(docv) end."

let seed =
  option [ "seed" ]
    (whole ~docv:"N" ~least:min_int)
    "N" "Chooses the random numbers: the same seed gives the same picture."

let filter =
  option [ "filter" ] filter "FILTER"
    "How samples spread around a pixel: $(b,box) or $(b,tent)."

let error =
  option [ "error" ] error "E"
    "Take as many samples, where they are needed, as bring the RMS error of \
     the displayed picture to $(docv) or below, in units of 1/255."

let time =
  option [ "time" ] duration "T"
    "Spend this time, such as $(b,30s) or $(b,5m), reading and writing \
     included, on as many samples as it allows, where they are needed. Pixels \
     that there is no time for show what one nearby does."

let domain_count =
  let parse s =
    match int_of_string_opt s with
    | Some n when n >= 1 && n <= 128 -> Ok n
    | Some _ | None -> Error ("'" ^ s ^ "': expected a number from 1 to 128")
  in
  Arg.Conv.make ~docv:"N" ~parser:parse ~pp:Format.pp_print_int ()

let domains =
  option [ "j" ] domain_count "N"
    "How many domains (cores) work at once; default all. The picture does not \
     depend on it."

let term =
  let make size spp depth cutoff seed filter =
    { size; spp; depth; cutoff; seed; filter; error = None; time = None }
  in
  Term.(const make $ size $ spp $ depth $ cutoff $ seed $ filter)

let with_targets =
  let add o error time = { o with error; time } in
  Term.(const add $ term $ error $ time)

let choose_samples o =
  Option.is_some o.spp || Option.is_some o.error || Option.is_some o.time

(* Any of the three replaces all three of the scene's. *)
let samples o (s : Scene.settings) =
  match (o.spp, o.error, o.time) with
  | None, None, None -> s
  | Some spp, error, time -> { s with spp; error; time }
  | None, error, time -> { s with spp = Scene.most_samples; error; time }

let apply o (s : Scene.t) =
  let width, height = Option.value o.size ~default:(s.width, s.height) in
  let or_ given x = Option.value given ~default:x in
  let ({ Scene.depth; cutoff; seed; filter; _ } as settings) =
    samples o s.settings
  in
  let settings =
    {
      settings with
      depth = (if Option.is_some o.depth then o.depth else depth);
      cutoff = or_ o.cutoff cutoff;
      seed = or_ o.seed seed;
      filter = or_ o.filter filter;
    }
  in
  { s with width; height; settings }

let warnings o plan scene =
  let off e =
    "--depth 0 switches off "
    ^ Candor_effect.Effect.name e
    ^ ", which the scene calls for"
  in
  match o.depth with
  | Some 0 -> List.map off (Candor_effect.Plan.cut_at_once plan scene)
  | Some _ | None -> []

(* {1 Scenes} *)

let scene =
  Arg.(
    required
    & pos 0 (some string) None
    & info [] ~docv:"SCENE" ~doc:"The scene file to work on.")

let read file =
  Result.map_error
    (fun report ->
      Format.eprintf "%a%!" Candor_read.Error.pp_report report;
      Status.Reported)
    (Candor_read.Scene_file.read file)

let all_effects =
  Arg.(
    value & flag
    & info [ "all-effects" ]
        ~doc:
          "Compile every effect in, whether the scene calls for it or not. \
           Same picture, bit for bit; more time.")

let math =
  let naive =
    Arg.(
      value & flag
      & info [ "naive-math" ]
          ~doc:
            "Meet surfaces by the formulas of textbooks, with an epsilon of \
             1e-4, to see what stability costs and what breaks without it.")
  in
  let of_flag naive : Candor_surface.Math.t =
    if naive then Textbook else Stable
  in
  Term.(const of_flag $ naive)

let plan ~all_effects scene =
  if all_effects then Candor_effect.Plan.all scene
  else Candor_effect.Plan.of_scene scene
