open Price

let element = Markup.element
let text = Markup.text
let div kind children = element "div" [ ("class", kind) ] children
let p kind children = element "p" [ ("class", kind) ] children

(* {1 What to choose} *)

let of_pixel (r : row) =
  match r.setting with
  | Samples _ -> " a pixel"
  | Depth _ | Cutoff _ | Sampler _ | Without_light _ | Without_effect _
  | Naive_math ->
      ""

let advice p =
  match (p.knee, List.rev p.ladder) with
  | Some k, _ -> "Choose " ^ Wording.setting k.setting ^ of_pixel k
  | None, [] -> "Nothing was measured"
  | None, finest :: _ ->
      "No setting stands out up to " ^ Wording.setting finest.setting

let one p =
  match List.find_opt (fun (c : prediction) -> c.error = 1.) p.predictions with
  | None -> ""
  | Some c ->
      Printf.sprintf " An error of 1/255 takes %s (95 %%: %s)."
        (Amount.seconds c.seconds)
        (Amount.range c.low c.high)

let because p =
  match p.knee with
  | Some k ->
      Printf.sprintf
        "The picture is then off by %s and takes %s; beyond, time buys less."
        (Wording.rms k.measure.rms)
        (Amount.seconds k.measure.seconds)
  | None ->
      if p.ladder = [] then "The budget allowed no rung of the ladder." else ""

let measured p =
  let share =
    float_of_int p.pixels /. float_of_int (Int.max 1 (p.width * p.height))
  in
  Printf.sprintf
    "%d × %d pixels · %s of them measured (%s) · %s · %s of a budget of %s"
    p.width p.height (Amount.whole p.pixels) (Amount.percent share)
    (Amount.count p.domains "core")
    (Amount.seconds p.spent) (Amount.seconds p.budget)

let tile (c : prediction) =
  div "tile"
    [
      element "span"
        [ ("class", "goal") ]
        [ text (Amount.target c.error ^ "/255") ];
      element "strong" [] [ text (Amount.seconds c.seconds) ];
      element "span" [] [ text (Amount.range c.low c.high) ];
      element "span" [] [ text (Amount.whole c.spp ^ " spp") ];
    ]

let tiles p =
  match p.predictions with
  | [] -> []
  | _ :: _ ->
      [
        element "section"
          [ ("aria-label", "predictions") ]
          [ div "tiles" (List.map tile p.predictions) ];
      ]

let finest p =
  match List.rev p.views with
  | [] -> []
  | v :: _ ->
      [
        element "figure"
          [ ("class", "finest") ]
          [
            Heat.image
              ~says:("the picture with " ^ Amount.count v.spp "sample")
              v.picture;
          ];
      ]

let header p' =
  element "header" []
    (div "words"
       [
         p "eyebrow"
           [ text "What accuracy costs in "; element "b" [] [ text p'.scene ] ];
         element "h1" [] [ text (advice p') ];
         p "lede" [ text (because p' ^ one p') ];
         p "facts" [ text (measured p') ];
       ]
    :: finest p')

(* {1 Sections} *)

let section title note children =
  element "section" []
    (element "h2" [] [ text title ]
     :: (if note = [] then [] else [ p "note" note ])
    @ children)

let swatch kind says =
  element "span"
    [ ("class", "swatch") ]
    [ element "i" [ ("class", kind) ] []; text says ]

let formula { a; b; scatter } =
  let factor = exp (1.96 *. scatter) in
  let spread =
    if Float.is_finite factor then
      Printf.sprintf ", within a factor of %s (95 %%)" (Amount.number factor)
    else ""
  in
  element "span"
    [ ("class", "swatch") ]
    [
      element "i" [ ("class", "law") ] [];
      text ("fitted: error ≈ " ^ Amount.number a ^ " · t");
      element "sup" [] [ text (Amount.number (-.b)) ];
      text spread;
    ]

let plot p =
  section "Error against time"
    [
      text
        "Each point is the whole picture, as displayed, beside the finest \
         rung; labels are samples a pixel.";
    ]
    [
      div "figure"
        [
          Plot.v ~width:1080. ~height:540. p; Plot.v ~width:380. ~height:400. p;
        ];
      div "swatches"
        ([
           swatch "sample" "ladder of samples";
           swatch "front" "Pareto front";
           swatch "knee" "knee";
           swatch "other" "other settings (letters: see the table)";
           swatch "range" "predicted time, 95 %";
         ]
        @ Option.fold ~none:[] ~some:(fun law -> [ formula law ]) p.law);
    ]

let table p =
  section "The price list"
    [
      text
        "Times are of the whole picture. Below the ladder, differences from \
         the same samples with nothing changed.";
    ]
    [ Price_table.v p ]

let shares p =
  section "What lights and effects cost"
    [
      text
        "Time is what leaving each out would save; one may save another's too, \
         so shares need not add up.";
    ]
    [ Shares.bars p ]

let nothing p =
  section "Paid for nothing"
    [ text "What costs time and changes nothing that shows." ]
    [ Shares.nothing p ]

let savings p =
  match Shares.savings p with
  | None -> []
  | Some list ->
      [
        section "Cheaper, and it does not show"
          [
            text
              "Settings that save time at no loss that shows; samplers, at \
               equal error.";
          ]
          [ list ];
      ]

let rungs p =
  match p.views with
  | [] -> []
  | _ :: _ ->
      [
        section "The picture at every rung"
          [
            text
              "Of the pixels that were measured: the picture, and how far each \
               pixel is off.";
          ]
          [ Gallery.rungs p ];
      ]

let maps p = section "Where it goes" [] [ Gallery.maps p ]

(* {1 The page} *)

let meta attributes = Markup.void "meta" attributes

(* The policy makes the browser keep the promise of needing nothing else. *)
let head p =
  let policy = "default-src 'none'; style-src 'unsafe-inline'; img-src data:" in
  element "head" []
    [
      meta [ ("charset", "utf-8") ];
      meta [ ("http-equiv", "Content-Security-Policy"); ("content", policy) ];
      meta
        [
          ("name", "viewport");
          ("content", "width=device-width, initial-scale=1");
        ];
      meta [ ("name", "color-scheme"); ("content", "light dark") ];
      element "title" [] [ text (p.scene ^ ": what accuracy costs") ];
      element "style" [] [ text Style.css ];
    ]

let html p =
  let sections =
    [ plot p; table p; shares p; nothing p ] @ savings p @ rungs p @ [ maps p ]
  in
  let footer =
    element "footer" [] [ text "Made by Candor: candor cost --html" ]
  in
  Markup.document
    (element "html"
       [ ("lang", "en") ]
       [
         head p;
         element "body" []
           [ element "main" [] ((header p :: tiles p) @ sections @ [ footer ]) ];
       ])
