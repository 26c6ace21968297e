open Candor_cost
open Candor_oracle

let read markup =
  match Html_reader.read (Markup.document markup) with
  | Ok events -> events
  | Error why -> Alcotest.fail why

let kinds markup =
  List.filter_map
    (function
      | Html_reader.Open { name; attributes } ->
          Option.map (fun k -> (name, k)) (List.assoc_opt "class" attributes)
      | Close _ | Text _ -> None)
    (read markup)

let how_many kind markup = List.length (List.filter (( = ) kind) (kinds markup))
let plot p = Plot.v ~width:1000. ~height:500. p

let complete () =
  let p = Lazy.force Showcase.price in
  let is what n kind = Alcotest.(check int) what n (how_many kind (plot p)) in
  is "the ladder" 5 ("circle", "sample");
  is "the knee" 1 ("circle", "knee");
  is "the front" 1 ("polyline", "front");
  is "the law" 1 ("polyline", "law");
  is "targets" 4 ("line", "target");
  is "and their prices" 4 ("text", "price")

let with_rms rms (p : Price.t) =
  let measured (r : Price.row) = { r with measure = { r.measure with rms } } in
  { p with ladder = List.map measured p.ladder; others = []; knee = None }

let edges () =
  let p = Lazy.force Showcase.price in
  let is what rms n kind =
    Alcotest.(check int) what n (how_many kind (plot (with_rms rms p)))
  in
  is "no error: arrows at the edge" 0. 5 ("polygon", "sample");
  is "infinite errors likewise" infinity 5 ("polygon", "sample");
  is "no number: no mark" nan 0 ("polygon", "sample");
  is "no number: no mark" nan 0 ("circle", "sample")

let suite =
  ( "plots",
    [
      Law.example "all that was measured is drawn" complete;
      Law.example "errors that no logarithm has are arrows" edges;
    ] )
