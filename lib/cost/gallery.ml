open Price

let element name kind children =
  Markup.element name [ ("class", kind) ] children

let figure kind images caption =
  element "figure" kind
    [ element "div" "pair" images; Markup.element "figcaption" [] caption ]

let row p (v : view) =
  let of_view (r : row) = r.setting = Samples v.spp in
  List.find_opt of_view p.ladder

let rung p (v : view) =
  let name = Amount.count v.spp "sample" in
  let row = row p v in
  let measured (r : row) =
    Printf.sprintf " %s · %s rms"
      (Amount.seconds r.measure.seconds)
      (Wording.rms r.measure.rms)
  in
  let chosen = Option.fold ~none:false ~some:(Ladder.is_knee p) row in
  let knee =
    if chosen then [ element "span" "chip knee" [ Markup.text "knee" ] ] else []
  in
  figure
    (if chosen then "rung chosen" else "rung")
    [
      Heat.image ~says:("the picture with " ^ name) v.picture;
      Heat.image
        ~says:("its errors with " ^ name)
        (Heat.map Heat.errors v.error);
    ]
    (Markup.element "strong" [] [ Markup.text name ]
    :: Markup.text (Option.fold ~none:"" ~some:measured row)
    :: knee)

let rungs p =
  Markup.element "div" []
    [
      element "div" "scale"
        [
          Markup.element "p" [] [ Markup.text "error of a pixel, in 1/255" ];
          Heat.legend Heat.errors;
        ];
      element "div" "rungs" (List.map (rung p) p.views);
    ]

let map title says heat plane =
  element "figure" "map"
    [
      Heat.image ~says (Heat.map heat plane);
      Heat.legend heat;
      Markup.element "figcaption" []
        [
          Markup.element "strong" [] [ Markup.text title ];
          Markup.text (" " ^ says);
        ];
    ]

let maps p =
  element "div" "maps"
    [
      map "Time" "that a sample takes in each pixel" (Heat.seconds p.time)
        p.time;
      map "Samples" "that adaptive sampling would give each pixel, their mean 1"
        Heat.shares p.samples;
    ]
