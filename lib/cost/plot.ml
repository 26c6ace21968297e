open Price

let size = 13. (* of letters, as in the style *)

type t = {
  x : Scale.t;
  y : Scale.t;
  left : float;
  top : float;
  right : float;
  bottom : float;  (** the frame *)
}

(* {1 Axes} *)

(* Predictions far beyond what was measured would squeeze what was. *)
let axes ~width ~height p =
  let left = 44. and top = 34. and bottom = height -. 42. in
  let right = width -. if width < 600. then 86. else 104. in
  let rows = p.ladder @ p.others in
  let seconds = List.map (fun (r : row) -> r.measure.seconds) rows in
  let most = 64. *. List.fold_left Float.max 0. seconds in
  let near (c : prediction) =
    if c.seconds < most then Some c.seconds else None
  in
  let x = seconds @ List.filter_map near p.predictions in
  let y =
    List.map (fun (r : row) -> r.measure.rms) p.ladder
    @ List.map (fun (c : prediction) -> c.error) p.predictions
  in
  {
    x = Scale.v ~from:left ~into:right ~margin:1.4 x;
    y = Scale.v ~from:bottom ~into:top ~margin:1.4 y;
    left;
    top;
    right;
    bottom;
  }

let on scale x f =
  match Scale.place scale x with
  | At c -> [ f c ]
  | Below | Above | Nowhere -> []

(* Those of ascending coordinates that leave [room] to the one before. *)
let spaced room ticks =
  let add kept (c, says) =
    match kept with
    | (before, _) :: _ when Float.abs (c -. before) < room -> kept
    | [] | _ :: _ -> (c, says) :: kept
  in
  List.fold_left add [] ticks

let ticks scale show values =
  List.concat_map (fun v -> on scale v (fun c -> (c, show v))) values

let grid f =
  let times = ticks f.x Amount.seconds (Scale.times f.x)
  and errors = ticks f.y Amount.target (Scale.decades f.y) in
  let upright (x, _) = Svg.line "grid" (x, f.top) (x, f.bottom)
  and level (y, _) = Svg.line "grid" (f.left, y) (f.right, y)
  and time (x, says) = Svg.text "tick" Middle (x, f.bottom +. 18.) says
  and error (y, says) = Svg.text "tick" End (f.left -. 8., y +. 4.) says in
  List.concat
    [
      List.map upright times;
      List.map level errors;
      List.map time (spaced 54. times);
      List.map error (spaced 18. errors);
    ]

let names f =
  [
    Svg.text "axis" Start (0., 14.) "error, rms in 1/255";
    Svg.text "axis" End (f.right, f.bottom +. 36.) "time of the whole picture";
  ]

(* {1 The law} *)

let law f { a; b; scatter } =
  let at shift l = Scale.log_coordinate f.y (log a -. (b *. l) +. shift) in
  let ends shift =
    let y1, y2 = Scale.power f.x (at shift) in
    [ (0., y1 -. f.top); (f.right -. f.left, y2 -. f.top) ]
  in
  let band spread =
    Svg.path ~closed:true "band" (ends spread @ List.rev (ends (-.spread)))
  in
  let spread = 1.96 *. scatter in
  let line = [ Svg.path "law" (ends 0.) ] in
  [
    Svg.window (f.left, f.top)
      (f.right -. f.left, f.bottom -. f.top)
      (if Float.is_finite spread then band spread :: line else line);
  ]

(* {1 Predictions} *)

let within f x = Option.value ~default:f.left (Scale.clamped f.x x)

let prediction f (c : prediction) =
  let says =
    Printf.sprintf "An error of %s takes %s (95 %%: %s), about %s spp"
      (Wording.rms c.error) (Amount.seconds c.seconds)
      (Amount.range c.low c.high)
      (Amount.whole c.spp)
  and label =
    Printf.sprintf "%s in %s" (Amount.target c.error) (Amount.seconds c.seconds)
  in
  on f.y c.error (fun y ->
      Svg.hint says
        (Svg.line "target" (f.left, y) (f.right, y)
        :: Svg.line "range" (within f c.low, y) (within f c.high, y)
        :: Svg.text "price" Start (f.right +. 8., y +. 4.) label
        :: on f.x c.seconds (fun x -> Svg.circle "goal" (x, y) 3.5)))

(* {1 Rows} *)

let says (r : row) =
  Printf.sprintf "%s: %s, %s rms, 99 %% of pixels within %s"
    (Wording.setting r.setting)
    (Amount.seconds r.measure.seconds)
    (Wording.rms r.measure.rms)
    (Wording.rms r.measure.p99)

(* A mark, and whether it is where it belongs, or as near as the axes go. *)
let spot f (r : row) =
  match
    (Scale.clamped f.x r.measure.seconds, Scale.place f.y r.measure.rms)
  with
  | None, _ | Some _, Nowhere -> None
  | Some x, At y -> Some (x, y, None)
  | Some x, Below -> Some (x, f.bottom -. 4., Some 1.)
  | Some x, Above -> Some (x, f.top +. 4., Some (-1.))

let mark kind radius f r =
  match spot f r with
  | None -> []
  | Some (x, y, None) -> [ Svg.hint (says r) [ Svg.circle kind (x, y) radius ] ]
  | Some (x, y, Some down) ->
      let tip =
        [
          (x -. 5., y -. (4. *. down));
          (x +. 5., y -. (4. *. down));
          (x, y +. (4. *. down));
        ]
      in
      [ Svg.hint (says r) [ Svg.path ~closed:true kind tip ] ]

let by_time (a : row) (b : row) =
  Float.compare a.measure.seconds b.measure.seconds

let front f p =
  let rows = List.filter (fun r -> r.pareto) (p.ladder @ p.others) in
  let point r =
    match spot f r with
    | Some (x, y, None) -> Some (x, y)
    | Some (_, _, Some _) | None -> None
  in
  match List.filter_map point (List.sort by_time rows) with
  | [] | [ _ ] -> []
  | points -> [ Svg.path "front" points ]

let knee f p =
  let ring r =
    match spot f r with
    | None -> []
    | Some (x, y, _) -> [ Svg.circle "knee" (x, y) 9. ]
  in
  Option.fold ~none:[] ~some:ring p.knee

let label ~unit (r : row) =
  match r.setting with
  | Samples n -> string_of_int n ^ unit
  | Depth _ | Cutoff _ | Sampler _ | Without_light _ | Without_effect _
  | Naive_math ->
      Wording.setting r.setting

let labels f p =
  let wish clear style text r =
    match spot f r with
    | None -> []
    | Some (x, y, _) -> [ { Labels.mark = (x, y); clear; text; style } ]
  in
  let knee = Option.to_list p.knee in
  let rungs = List.filter (fun r -> not (List.memq r knee)) p.ladder in
  let marks = List.filter_map (spot f) (p.ladder @ p.others) in
  let around r (x, y, _) = Labels.around (x, y) r in
  let taken =
    List.map (around 4.) marks
    @ List.map (around 9.) (List.filter_map (spot f) knee)
  in
  List.concat_map
    (fun r -> wish 10. "best" (label ~unit:" spp" r ^ ", the knee") r)
    knee
  @ List.concat_map (fun r -> wish 6. "rung" (label ~unit:"" r) r) rungs
  @ List.concat (List.mapi (fun i -> wish 5. "key" (Wording.key i)) p.others)
  |> Labels.place ~size
       ~within:
         {
           left = f.left;
           top = f.top;
           width = f.right -. f.left;
           height = f.bottom -. f.top;
         }
       ~taken
  |> List.map (fun (l : Labels.t) -> Svg.text l.kind l.anchor l.at l.says)

let v ~width ~height p =
  let f = axes ~width ~height p in
  let kind = if width < 600. then "plot narrow" else "plot wide" in
  Svg.drawing ~width ~height ~kind
    ~says:"Error against seconds, both on logarithmic axes"
    (List.concat
       [
         grid f;
         Option.fold ~none:[] ~some:(law f) p.law;
         List.concat_map (prediction f) p.predictions;
         front f p;
         List.concat_map (mark "other" 4. f) p.others;
         List.concat_map (mark "sample" 5.5 f) p.ladder;
         knee f p;
         labels f p;
         names f;
       ])
