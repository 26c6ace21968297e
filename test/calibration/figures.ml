(* What was measured, as tables. *)

let line = Printf.sprintf
let lines = String.concat "\n"

(* Below this a scene is rejected. *)
let level = 0.001

(* {1 Coverage} *)

let coverage_cell (c : Coverage.t) confidence =
  let share =
    float_of_int (Coverage.inside c ~confidence)
    /. float_of_int (Coverage.count c)
  in
  let rejected = Coverage.p_value c ~confidence < level in
  line "%6.2f%s" share (if rejected then "!" else " ")

let coverage_row (c : Coverage.t) =
  line "%-14s %4d %9.2f %9.2f  %s" c.name c.spp (Coverage.error c)
    (Coverage.said c)
    (String.concat "" (List.map (coverage_cell c) Coverage.promised))

let coverage cs =
  let pooled confidence = line "%6.3f " (Coverage.pooled cs ~confidence) in
  let rejected confidence =
    let is c = Coverage.p_value c ~confidence < level in
    line "%6d " (List.length (List.filter is cs))
  in
  let foot name f =
    line "%-39s %s" name (String.concat "" (List.map f Coverage.promised))
  in
  lines
    (line "%-14s %4s %9s %9s  %6s %6s %6s" "scene" "spp" "error" "estimate"
       ".68" ".95" ".99"
     :: List.map coverage_row cs
    @ [ foot "all" pooled; foot "rejected" rejected ])

(* {1 Targets} *)

let aim_row (a : Aim.t) =
  line "%-14s %7.2f %5.2f %6.2f%s %8.1f %8.2f %6.2f" a.name a.error a.confidence
    (Aim.kept a)
    (if Aim.fails a ~level then "!" else " ")
    (Aim.samples a) (Aim.spent a.runs 0.5) (Aim.spent a.runs 0.95)

let of_confidence aims confidence =
  List.filter (fun (a : Aim.t) -> a.confidence = confidence) aims
  |> List.concat_map (fun (a : Aim.t) -> a.runs)

let aim_foot aims confidence =
  let runs = of_confidence aims confidence in
  line "%-22s %5.2f %6.3f  %8s %8.2f %6.2f" "all" confidence
    (Aim.share (fun (r : Aim.run) -> r.kept) runs)
    "" (Aim.spent runs 0.5) (Aim.spent runs 0.95)

let aims confidences aims =
  lines
    (line "%-14s %7s %5s %6s  %8s %8s %6s" "scene" "target" "conf." "kept" "spp"
       "x needed" "p95"
     :: List.map aim_row aims
    @ List.map (aim_foot aims) confidences)

(* {1 Forecasts} *)

let nth_forecasts runs n =
  List.filter_map
    (fun (r : Aim.run) ->
      Option.map (fun f -> (f, r.samples)) (List.nth_opt r.forecasts n))
    runs

let forecast_row name fs =
  let off p = Aim.quantile p (List.map Aim.off fs) in
  line "%-8s %7d %6.2f %9.2f %6.2f" name (List.length fs)
    (Aim.share Aim.held fs) (off 0.5) (off 0.95)

let forecasts aims =
  let runs = List.concat_map (fun (a : Aim.t) -> a.runs) aims in
  let rec rows n =
    match nth_forecasts runs n with
    | [] -> [ forecast_row "all" (Aim.forecasts runs) ]
    | fs -> forecast_row (string_of_int (n + 1)) fs :: rows (n + 1)
  in
  lines
    (line "%-8s %7s %6s %9s %6s" "forecast" "number" "held" "off by" "p95"
    :: rows 0)

(* {1 Bias} *)

let bias_row (b : Bias.t) =
  line "%-10s %5s %6.2f %7.1f  %5.1f .. %-6.1f %7.3f %7.2f" b.name
    (Printf.sprintf "%dx%d" b.width b.height)
    b.error b.samples b.least b.most b.rms_z b.z

let bias bs =
  lines
    (line "%-10s %5s %6s %7s  %5s .. %-6s %7s %7s" "scene" "size" "target" "spp"
       "least" "most" "rms z" "z"
    :: List.map bias_row bs)
