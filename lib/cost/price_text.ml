open Candor_scene
open Candor_effect

let setting : Price.setting -> string = function
  | Samples n -> Printf.sprintf "spp %d" n
  | Depth n -> Printf.sprintf "depth %d" n
  | Cutoff w -> Printf.sprintf "cutoff %g" w
  | Sampler s -> Candor_sample.Sampler.name s ^ " sampler"
  | Without_light { name; _ } -> "without " ^ name
  | Without_effect { absent; _ } -> "without " ^ Effect.name absent
  | Naive_math -> "naive math"

let place : Price.setting -> string option =
  let known place =
    if Place.equal place Place.unknown then None
    else Some (Place.to_string place)
  in
  function
  | Without_light { place; _ } -> known place
  | Without_effect { reasons; _ } ->
      List.find_map (fun (r : Reason.t) -> known r.place) reasons
  | Samples _ | Depth _ | Cutoff _ | Sampler _ | Naive_math -> None

(* {1 Numbers} *)

(* Two digits behind the first, but no more than six behind the point. *)
let decimals x =
  let x = Float.abs x in
  if x = 0. then 0
  else Int.max 0 (Int.min 6 (2 - int_of_float (Float.floor (log10 x))))

let with_decimals ~plain ~signed x =
  if Float.is_nan x then "?"
  else if Float.is_finite x then
    if signed then Printf.sprintf "%+.*f" (Int.min plain (decimals x)) x
    else Printf.sprintf "%.*f" (Int.min plain (decimals x)) x
  else if x > 0. then "inf"
  else "-inf"

let number = with_decimals ~plain:6 ~signed:false
let change = with_decimals ~plain:3 ~signed:true
let pixels_error = with_decimals ~plain:1 ~signed:false

(* {1 For people} *)

type line = {
  marked : bool;
  name : string;
  cells : string list;  (** seconds, rays, rms, 99th percentile *)
  says : string;
}

let mark (row : Price.row) = row.pareto

let rung p i ((row : Price.row), price) =
  let { Price.seconds; rays_per_pixel; rms; p99 } = row.measure in
  {
    marked = mark row;
    name =
      (setting row.setting ^ if Ladder.is_knee p row then "   <- knee" else "");
    cells =
      [ number seconds; number rays_per_pixel; number rms; pixels_error p99 ];
    says = (if i = 0 then "" else Option.fold ~none:"-" ~some:number price);
  }

let was (scene : Scene.t) : Price.setting -> string = function
  | Depth _ ->
      let depth = Scene.depth scene in
      if depth = max_int then " (was without limit)"
      else Printf.sprintf " (was %d)" depth
  | Cutoff _ when scene.settings.cutoff > 0. ->
      Printf.sprintf " (was %g)" scene.settings.cutoff
  | Cutoff _ | Samples _ | Sampler _ | Without_light _ | Without_effect _
  | Naive_math ->
      ""

let verdict (row : Price.row) =
  match (row.verdict, row.setting) with
  | Rung, _ -> ""
  | Needed, Sampler _ -> "no better"
  | Needed, _ -> "needed"
  | Saves share, Sampler _ ->
      Printf.sprintf "saves %.0f %% at equal error" (100. *. share)
  | Saves share, _ -> Printf.sprintf "saves %.0f %%" (100. *. share)
  | Paid_for_nothing, _ -> "paid for nothing"
  | Wrong_pixels 1, _ -> "1 wrong pixel"
  | Wrong_pixels n, _ -> Printf.sprintf "%d wrong pixels" n

let located (row : Price.row) =
  match place row.setting with
  | Some place -> setting row.setting ^ " [" ^ place ^ "]"
  | None -> setting row.setting

let other scene p (row : Price.row) =
  let base = Ladder.base p row in
  let beside f =
    match base with Some b -> f row.measure -. f b.measure | None -> nan
  in
  let name =
    match row.setting with
    | Without_light _ -> located row
    | Samples _ | Depth _ | Cutoff _ | Sampler _ | Without_effect _ | Naive_math
      ->
        setting row.setting ^ was scene row.setting
  in
  {
    marked = mark row;
    name;
    cells =
      [
        change (beside (fun m -> m.seconds));
        change (beside (fun m -> m.rays_per_pixel));
        change row.loss;
        change (beside (fun m -> m.p99));
      ];
    says = verdict row;
  }

let heads = [ "seconds"; "rays/px"; "rms (1/255)"; "99th pct" ]

let render lines =
  let width =
    List.fold_left
      (fun w line -> Int.max w (String.length line.name))
      (String.length "setting") lines
  in
  let cells =
    List.map2 (fun head -> Printf.sprintf "%*s" (2 + String.length head)) heads
  in
  let line { marked; name; cells = numbers; says } =
    let text =
      Printf.sprintf "%c%-*s%s  %s"
        (if marked then '*' else ' ')
        width name
        (String.concat "" (cells numbers))
        says
    in
    let rec trimmed n =
      if n > 0 && text.[n - 1] = ' ' then trimmed (n - 1) else n
    in
    String.sub text 0 (trimmed (String.length text)) ^ "\n"
  in
  let head =
    { marked = false; name = "setting"; cells = heads; says = "s per halving" }
  in
  String.concat "" (List.map line (head :: lines))

let nothing (row : Price.row) =
  match row.verdict with
  | Paid_for_nothing -> (
      match row.setting with
      | Without_light { name; _ } -> Some (row, name)
      | Without_effect { absent; _ } -> Some (row, Effect.name absent)
      | Samples _ | Depth _ | Cutoff _ | Sampler _ | Naive_math -> None)
  | Rung | Needed | Saves _ | Wrong_pixels _ -> None

let paid_for_nothing ((row : Price.row), name) =
  match place row.setting with
  | Some place -> Printf.sprintf "paid for nothing: %s [%s]\n" name place
  | None -> Printf.sprintf "paid for nothing: %s\n" name

let law { Price.a; b; scatter } =
  let scatter =
    if Float.is_finite scatter then
      Printf.sprintf " (within a factor of %.2f)" (exp scatter)
    else ""
  in
  Printf.sprintf "error = %s / seconds^%.2f%s\n" (number a) b scatter

let time = Candor_render.Progress.time

let prediction { Price.error; seconds; low; high; spp } =
  let range =
    if Float.is_finite high then
      Printf.sprintf " (95 %%: %s to %s)" (time low) (time high)
    else ""
  in
  Printf.sprintf "error %g takes %s%s, %d spp everywhere\n" error (time seconds)
    range spp

let table scene (p : Price.t) =
  let lines =
    List.mapi (rung p) (Ladder.per_halving p)
    @ List.map (other scene p) p.others
  in
  render lines
  ^ String.concat ""
      (List.map paid_for_nothing (List.filter_map nothing p.others))
  ^ Option.fold ~none:"" ~some:law p.law
  ^ String.concat "" (List.map prediction p.predictions)

(* {1 For programs} *)

let quoted text =
  if String.exists (fun c -> c = ',' || c = '"' || c = '\n' || c = '\r') text
  then "\"" ^ String.concat "\"\"" (String.split_on_char '"' text) ^ "\""
  else text

let csv (p : Price.t) =
  let line (row : Price.row) =
    let { Price.seconds; rays_per_pixel; rms; p99 } = row.measure in
    Printf.sprintf "%s,%d,%.6g,%.6g,%.6g,%.6g,%b\n"
      (quoted (located row))
      row.spp seconds rays_per_pixel rms p99 row.pareto
  in
  "setting,spp,seconds,rays_per_pixel,rms,p99,pareto\n"
  ^ String.concat "" (List.map line (p.ladder @ p.others))
