open Candor_colour
open Candor_scene
open Candor_effect
open Candor_image
open Candor_surface

type output = { clamped : int; rounding : float }

let output picture =
  let width = Picture.width picture and height = Picture.height picture in
  (* Local mutation: two running sums over the picture. *)
  let clamped = ref 0 and squares = ref 0. in
  let lost x =
    let shown = Display.encode x in
    let e = shown -. float_of_int (Display.nearest shown) in
    squares := !squares +. (e *. e)
  in
  for y = 0 to height - 1 do
    for x = 0 to width - 1 do
      let c = Picture.pixel picture x y in
      if Rgb.largest c > 1. then incr clamped;
      lost c.r;
      lost c.g;
      lost c.b
    done
  done;
  let n = float_of_int (3 * width * height) in
  { clamped = !clamped; rounding = sqrt (!squares /. n) }

(* Of the pixels of the picture, without those beyond that stand in for some. *)
let map (r : Render.report) = Sample_map.crop r.map r.window

let words_per_ray (r : Render.report) =
  r.words /. float_of_int (Int.max 1 (Tally.total_rays r.tally))

let amount n =
  let x = float_of_int n in
  if x >= 1e9 then Printf.sprintf "%.2f G" (x /. 1e9)
  else if x >= 1e6 then Printf.sprintf "%.1f M" (x /. 1e6)
  else if x >= 1e4 then Printf.sprintf "%.1f k" (x /. 1e3)
  else Printf.sprintf "%d" n

let percent confidence = Printf.sprintf "%g %%" (100. *. confidence)

let target (r : Render.report) =
  match r.aim with
  | None | Some { target = { error = None; _ }; _ } -> ""
  | Some { target = { error = Some error; _ }; ending; _ } -> (
      let says word = Printf.sprintf "   target %.4g %s" error word in
      match ending with
      | Met -> says "met"
      | Misjudged -> says "missed: parts of the picture misjudged each other"
      | Out_of_time -> says "missed: out of time"
      | Out_of_samples -> says "missed: out of samples")

(* With as many digits as tell an error from its interval. *)
let amount_of_error x =
  if x >= 0.1 || x = 0. then Printf.sprintf "%.2f" x
  else Printf.sprintf "%.2g" x

let sampling ~confidence (r : Render.report) =
  match (Sampling.rms r.sampling, Sampling.interval ~confidence r.sampling) with
  | Some rms, Some { low; high } ->
      let show = amount_of_error in
      Printf.sprintf "%s/255 rms (%s: %s .. %s)%s" (show rms)
        (percent confidence) (show low) (show high) (target r)
  | (Some _ | None), (Some _ | None) ->
      if Option.is_some r.non_finite_pixel then
        "unknown: a sample is not finite"
      else if Sample_map.least (map r) = 0 then
        Printf.sprintf "unknown: no sample in %s of %d, shown as one nearby%s"
          (Plural.count (Sample_map.empty (map r)) "pixel")
          (Window.width r.window * Window.height r.window)
          (target r)
      else
        let n = Sample_map.least (map r) in
        Printf.sprintf "unknown: %s a pixel %s too few to tell, 4 are enough%s"
          (Plural.count n "sample")
          (if n = 1 then "is" else "are")
          (target r)

let numerics (r : Render.report) =
  let effort = Tally.effort r.tally in
  let samples =
    Printf.sprintf
      "%s of %s tests needed more than plain doubles; %d non-finite"
      (amount (Effort.careful effort))
      (amount (Effort.tests effort))
      (Tally.get r.tally Non_finite)
  in
  match r.non_finite_pixel with
  | None -> samples
  | Some (x, y) ->
      Printf.sprintf
        "%s samples, the first in pixel %d %d: see candor trace SCENE %d %d"
        samples x y x y

let output_line (format : Picture_file.format) picture =
  match format with
  | Pfm -> "linear radiance in 32-bit floats: nothing is clamped"
  | Ppm | Png ->
      let { clamped; rounding } = output picture in
      Printf.sprintf "%s clamped at 255; 8-bit rounding %.2f/255"
        (Plural.count clamped "pixel")
        rounding

let size w = Printf.sprintf "%dx%d" (Window.width w) (Window.height w)

let samples (r : Render.report) =
  let least =
    let least = Sample_map.least (map r) in
    if Tally.get r.tally Spared_samples > 0 then Int.min 1 least else least
  and most = Sample_map.most (map r) in
  if least = most then string_of_int most
  else Printf.sprintf "%d..%d" least most

let text ~name ~format ~confidence ?(warnings = []) (scene : Scene.t)
    (r : Render.report) =
  let headline =
    Printf.sprintf "%s  %s  %s spp  %.2f s  %s rays  %.1f words/ray" name
      (size r.window) (samples r) r.seconds
      (amount (Tally.total_rays r.tally))
      (words_per_ray r)
  in
  let line (what, says) = Printf.sprintf "  %-10s %s" what says in
  let warnings = List.map (fun warning -> ("warning", warning)) warnings in
  headline
  :: List.map line
       ([
          ("sampling", sampling ~confidence r);
          ("cut-off", Cut_off.text scene r.tally r.cut_off);
          ("numerics", numerics r);
          ("output", output_line format r.picture);
        ]
       @ warnings)
  |> String.concat "\n"

(* {1 For programs} *)

let json_rays r =
  let one c = (Tally.name c, Json.Int (Tally.get r.Render.tally c)) in
  Json.Object
    (("total", Json.Int (Tally.total_rays r.tally)) :: List.map one Tally.rays)

let json_effects plan =
  let one e = (Effect.name e, Json.Bool (Plan.is_on plan e)) in
  Json.Object (List.map one Effect.all)

let json_image (scene : Scene.t) (r : Render.report) =
  let w = r.window in
  Json.Object
    [
      ("width", Int (w.x1 - w.x0));
      ("height", Int (w.y1 - w.y0));
      ("crop", List [ Int w.x0; Int w.y0; Int w.x1; Int w.y1 ]);
      ("spp", Int (Sample_map.most (map r)));
      ("least_spp", Int (Sample_map.least (map r)));
      ("samples", Float (Sample_map.total (map r)));
      ("spared_samples", Int (Tally.get r.tally Spared_samples));
      ("seed", Int scene.settings.seed);
    ]

let json_sampling ~confidence (r : Render.report) =
  let option = Option.fold ~none:Json.Null ~some:(fun x -> Json.Float x) in
  let interval = Sampling.interval ~confidence r.sampling in
  let target =
    match r.aim with
    | None | Some { target = { error = None; _ }; _ } -> []
    | Some { target = { error = Some error; _ }; ending; _ } ->
        let met =
          match ending with
          | Met -> true
          | Misjudged | Out_of_time | Out_of_samples -> false
        in
        [ ("target", Json.Float error); ("met", Bool met) ]
  in
  Json.Object
    ([
       ("rms", option (Sampling.rms r.sampling));
       ("confidence", Json.Float confidence);
       ("low", option (Option.map (fun i -> i.Sampling.low) interval));
       ("high", option (Option.map (fun i -> i.Sampling.high) interval));
     ]
    @ target)

let json_ledger ~confidence (r : Render.report) =
  let { clamped; rounding } = output r.picture in
  let cut c = Json.Int (Tally.get r.tally c) in
  let effort = Tally.effort r.tally in
  Json.Object
    [
      ("sampling", json_sampling ~confidence r);
      ("cut-off", Cut_off.json r.tally r.cut_off);
      ( "numerics",
        Object
          [
            ("tests", Int (Effort.tests effort));
            ("careful", Int (Effort.careful effort));
            ("non_finite", cut Non_finite);
          ] );
      ( "output",
        Object [ ("clamped", Int clamped); ("rounding", Float rounding) ] );
    ]

let json ~confidence scene plan (r : Render.report) =
  Json.Object
    [
      ("rays", json_rays r);
      ("effects", json_effects plan);
      ("seconds", Float r.seconds);
      ("words_per_ray", Float (words_per_ray r));
      ("domains", Int r.domains);
      ("image", json_image scene r);
      ("ledger", json_ledger ~confidence r);
    ]
