open Price

let cell ?(kind = "n") children =
  Markup.element "td" [ ("class", kind) ] children

let number s = cell [ Markup.text s ]

(* What narrow screens leave out. *)
let extra children = cell ~kind:"n extra" children

let chip kind says =
  Markup.element "span" [ ("class", "chip " ^ kind) ] [ Markup.text says ]

let heading ~key name chips =
  Markup.element "th"
    [ ("scope", "row") ]
    (Markup.element "span" [ ("class", "key") ] [ Markup.text key ]
    :: Markup.text name :: chips)

let pareto (r : row) =
  if r.pareto then
    Markup.element "span"
      [ ("class", "pareto"); ("title", "nothing is both faster and better") ]
      [ Markup.text "●" ]
  else Markup.text ""

let line p (r : row) cells =
  let kind = if Ladder.is_knee p r then [ ("class", "chosen") ] else [] in
  Markup.element "tr" kind cells

let rung p (r, price) =
  let knee = if Ladder.is_knee p r then [ chip "knee" "knee" ] else [] in
  line p r
    [
      heading ~key:"" (Wording.setting r.setting) knee;
      number (Amount.seconds r.measure.seconds);
      extra [ Markup.text (Amount.number r.measure.rays_per_pixel) ];
      number (Amount.error r.measure.rms);
      extra [ Markup.text (Amount.error r.measure.p99) ];
      extra [ pareto r ];
      cell ~kind:"says"
        [ Markup.text (Option.fold ~none:"" ~some:Amount.seconds price) ];
    ]

let verdict (r : row) =
  let kind =
    match r.verdict with
    | Saves share when Wording.worth share -> "saves"
    | Paid_for_nothing -> "waste"
    | Wrong_pixels n when n > 0 -> "wrong"
    | Rung | Needed | Saves _ | Wrong_pixels _ -> "plain"
  in
  Option.fold ~none:[]
    ~some:(fun says -> [ chip kind says ])
    (Wording.verdict r)

let other p i (r : row) =
  let beside field =
    let base = Option.map field (Ladder.base p r) in
    field r -. Option.value ~default:0. base
  in
  let change show field = Markup.text (Amount.change show (beside field)) in
  line p r
    [
      heading ~key:(Wording.key i)
        (Wording.setting r.setting)
        [ Markup.element "span" [ ("class", "narrow-only") ] (verdict r) ];
      cell [ change Amount.seconds (fun r -> r.measure.seconds) ];
      extra [ change Amount.number (fun r -> r.measure.rays_per_pixel) ];
      number (Amount.change Amount.error r.loss);
      extra [ change Amount.error (fun r -> r.measure.p99) ];
      extra [ pareto r ];
      cell ~kind:"says" (verdict r);
    ]

let head last =
  let column (kind, says) =
    Markup.element "th"
      [ ("scope", "col"); ("class", kind) ]
      [ Markup.text says ]
  in
  Markup.element "tr" []
    (List.map column
       [
         ("", "setting");
         ("n", "time");
         ("n extra", "rays/px");
         ("n", "rms /255");
         ("n extra", "99th pct");
         ("n extra", "Pareto");
         ("says", last);
       ])

let part ~last lines =
  [ Markup.element "thead" [] [ head last ]; Markup.element "tbody" [] lines ]

let table parts =
  Markup.element "div"
    [
      ("class", "scroll");
      ("role", "region");
      ("aria-label", "price list");
      ("tabindex", "0");
    ]
    [ Markup.element "table" [] parts ]

let v p =
  let rungs = List.map (rung p) (Ladder.per_halving p)
  and others = List.mapi (other p) p.others in
  let second =
    match others with
    | [] -> []
    | _ :: _ ->
        [
          Markup.element "tbody"
            [ ("class", "changes") ]
            (head "verdict" :: others);
        ]
  in
  table (part ~last:"per halving" rungs @ second)
