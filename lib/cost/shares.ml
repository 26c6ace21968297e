open Price

let div kind children = Markup.element "div" [ ("class", kind) ] children
let span kind s = Markup.element "span" [ ("class", kind) ] [ Markup.text s ]

(* {1 Bars} *)

let bar kind share =
  let share = Float.max 0. (Float.min 1. share) in
  let width = Printf.sprintf "width:%s%%" (Svg.number (100. *. share)) in
  div "track" [ Markup.element "i" [ ("class", kind); ("style", width) ] [] ]

let losses = Scale.v ~from:0. ~into:1. ~margin:1.001 [ 0.01; 100. ]

(* A light or an effect: its name, the saving and the row. *)
let left_out p (r : row) =
  let entry kind name =
    Some (kind, name, Option.value ~default:0. (Ladder.saving p r), r)
  in
  match r.setting with
  | Without_light { name; place } -> entry ("light" ^ Wording.line place) name
  | Without_effect { absent; _ } ->
      entry "effect" (Candor_effect.Effect.name absent)
  | Samples _ | Depth _ | Cutoff _ | Sampler _ | Naive_math -> None

(* What is needed without being seen keeps noise down. *)
let lost (r : row) =
  if not (r.loss <= 0.) then Amount.error r.loss
  else
    match r.verdict with
    | Needed -> "noise"
    | Rung | Saves _ | Paid_for_nothing | Wrong_pixels _ -> "nothing"

let item (kind, name, saving, (r : row)) =
  let loss = Option.value ~default:0. (Scale.clamped losses r.loss) in
  Markup.element "li" []
    [
      div "what" [ Markup.text name; span "kind" kind ];
      bar "time" saving;
      span "amount" (Amount.percent saving);
      bar "loss" loss;
      span "amount" (lost r);
    ]

let axis says marks =
  div "over" [ Markup.element "span" [] [ Markup.text says ]; Heat.marks marks ]

let head =
  let decade i =
    (0.25 *. float_of_int i, Amount.target (10. ** float_of_int (i - 2)))
  in
  Markup.element "li"
    [ ("class", "head") ]
    [
      div "what" [];
      axis "time it takes" [ (0., "0"); (0.5, "50 %"); (1., "100 %") ];
      span "amount" "";
      axis "lost without it, rms in 1/255" (List.init 5 decade);
      span "amount" "";
    ]

let bars p =
  let dearest (_, _, a, _) (_, _, b, _) = Float.compare b a in
  match List.sort dearest (List.filter_map (left_out p) p.others) with
  | [] ->
      Markup.element "p" [] [ Markup.text "No light or effect was left out." ]
  | items ->
      Markup.element "ul" [ ("class", "shares") ] (head :: List.map item items)

(* {1 Paid for nothing} *)

let place (what, place) =
  Markup.element "li" []
    [
      Markup.element "code" []
        [ Markup.text (Candor_scene.Place.to_string place) ];
      Markup.text (" " ^ what);
    ]

let saved p (r : row) =
  let share =
    match r.verdict with
    | Saves share -> Some share
    | Rung | Needed | Paid_for_nothing | Wrong_pixels _ -> Ladder.saving p r
  in
  match share with
  | Some share when share > 0. ->
      [ span "amount" (Amount.percent share ^ " of the time") ]
  | Some _ | None -> []

let card kind p (says, (r : row)) =
  let title = Markup.element "strong" [] [ Markup.text says ] in
  let places =
    match Wording.places r.setting with
    | [] -> []
    | places -> [ Markup.element "ul" [] (List.map place places) ]
  in
  Markup.element "li" [ ("class", kind) ] ((title :: saved p r) @ places)

let cards kind p items =
  Markup.element "ul" [ ("class", "cards") ] (List.map (card kind p) items)

let wasted p (r : row) =
  let name =
    match left_out p r with
    | Some (_, name, _, _) -> name
    | None -> Wording.setting r.setting
  in
  match r.verdict with
  | Paid_for_nothing -> Some (name, r)
  | Rung | Needed | Saves _ | Wrong_pixels _ -> None

let saves (r : row) =
  match r.verdict with
  | Saves share when Wording.worth share -> Some (Wording.setting r.setting, r)
  | Rung | Needed | Saves _ | Paid_for_nothing | Wrong_pixels _ -> None

let nothing p =
  match List.filter_map (wasted p) p.others with
  | [] ->
      Markup.element "p" []
        [ Markup.text "Nothing: all that takes time shows in the picture." ]
  | items -> cards "waste" p items

let savings p =
  match List.filter_map saves p.others with
  | [] -> None
  | items -> Some (cards "saves" p items)
