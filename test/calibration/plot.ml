(* Coverage found against coverage promised, as SVG. *)

let size = 360.
let margin = 44.
let across p = margin +. (p *. size)
let down p = margin +. ((1. -. p) *. size)
let line = Printf.sprintf

let segment ?(more = "") (x, y) (x', y') =
  line {|<path d="M%.1f %.1fL%.1f %.1f" %s/>|} (across x) (down y) (across x')
    (down y') more

let dot (x, y) =
  line {|<circle cx="%.1f" cy="%.1f" r="2.5" class="scene"/>|} (across x)
    (down y)

let text ?(more = "") x y s =
  line {|<text x="%.1f" y="%.1f" %s>%s</text>|} x y more s

let ticks = List.init 6 (fun i -> float_of_int i /. 5.)

let tick t =
  [
    segment (t, 0.) (t, 1.) ~more:{|class="grid"|};
    segment (0., t) (1., t) ~more:{|class="grid"|};
    text (across t)
      (down 0. +. 16.)
      (line "%.1f" t) ~more:{|text-anchor="middle"|};
    text
      (across 0. -. 6.)
      (down t +. 4.)
      (line "%.1f" t) ~more:{|text-anchor="end"|};
  ]

let curve points =
  let at (x, y) = line "%.1f,%.1f" (across x) (down y) in
  line {|<polyline points="%s" class="found"/>|}
    (String.concat " " (List.map at points))

let style =
  "<style>text{font:12px \
   sans-serif;fill:#333}path{stroke:#999}.grid{stroke:#e4e4e4}.scene{fill:#c60;fill-opacity:.45}.found{fill:none;stroke:#06c;stroke-width:2}</style>"

(* Where the curve is known. *)
let levels =
  List.init 19 (fun i -> float_of_int (i + 1) /. 20.) @ [ 0.97; 0.98; 0.99 ]

let share (c : Coverage.t) confidence =
  float_of_int (Coverage.inside c ~confidence)
  /. float_of_int (Coverage.count c)

(** [svg cs] draws the curve of all runs, and each scene where it is promised
    something. *)
let svg cs =
  let side = size +. (2. *. margin) in
  let dots c = List.map (fun p -> dot (p, share c p)) Coverage.promised in
  let found =
    List.map (fun p -> (p, Coverage.pooled cs ~confidence:p)) levels
  in
  let middle = margin +. (size /. 2.) in
  String.concat "\n"
    ([
       line
         {|<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %g %g" width="%g" height="%g">|}
         side side side side;
       style;
       {|<rect width="100%" height="100%" fill="#fff"/>|};
     ]
    @ List.concat_map tick ticks
    @ [ segment (0., 0.) (1., 1.) ]
    @ List.concat_map dots cs
    @ [
        curve (((0., 0.) :: found) @ [ (1., 1.) ]);
        text middle (side -. 8.) "promised" ~more:{|text-anchor="middle"|};
        text 16. middle "found"
          ~more:
            (line {|text-anchor="middle" transform="rotate(-90 16 %g)"|} middle);
        "</svg>\n";
      ])
