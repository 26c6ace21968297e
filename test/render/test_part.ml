open Candor_render
open Candor_oracle
open QCheck2

let place = Gen.(pair (int_range (-1000) 1000) (int_range (-1000) 1000))
let print (x, y) = Printf.sprintf "%d %d" x y
let law name f = Law.law ~print name place f

(* Along a row, a column and both diagonals. *)
let meets_all (x, y) =
  let along (dx, dy) =
    List.map (fun k -> Part.of_pixel (x + (k * dx)) (y + (k * dy))) Part.all
    |> List.sort Int.compare
  in
  List.for_all
    (fun step -> along step = Part.all)
    [ (1, 0); (0, 1); (1, 1); (1, -1) ]

(* The parts of the pixels that advise one. *)
let advisers (x, y) =
  let first, second = Part.advisers in
  List.map (fun (dx, dy) -> Part.of_pixel (x + dx) (y + dy)) (first @ second)

let not_asked (x, y) =
  let own = Part.of_pixel x y and judges = Part.judges (Part.of_pixel x y) in
  let is_right x =
    let asks = List.mem own (advisers (x, y)) in
    let part = Part.of_pixel x y in
    List.mem part judges = not (asks || part = own)
  in
  (not (List.mem own (advisers (x, y))))
  && List.length judges = 48
  && List.for_all is_right (List.init Part.count (fun i -> x + i))

let window =
  let open Gen in
  let* x0 = int_range (-50) 50 and* y0 = int_range (-50) 50 in
  let+ w = int_range 1 40 and+ h = int_range 1 40 in
  { Window.x0; y0; x1 = x0 + w; y1 = y0 + h }

let counted (w : Window.t) =
  let of_row y =
    List.init (Window.width w) (fun i -> Part.of_pixel (w.x0 + i) y)
  in
  let rows = List.init (Window.height w) (fun j -> w.y0 + j) in
  let there = List.concat_map of_row rows in
  List.for_all (fun part -> Part.is_in w part = List.mem part there) Part.all

(* The mean square of the distance from a part to the nearest of some. *)
let distance_to parts =
  let offsets = List.init 61 (fun i -> i - 30) in
  let nearest part =
    let add best (dx, dy) =
      if List.mem (Part.of_pixel (part + dx) dy) parts then
        Int.min best ((dx * dx) + (dy * dy))
      else best
    in
    List.concat_map (fun dy -> List.map (fun dx -> (dx, dy)) offsets) offsets
    |> List.fold_left add max_int
  in
  float_of_int (List.fold_left (fun sum i -> sum + nearest i) 0 Part.all) /. 61.

(* A square lattice has a sixth of the area of each point. *)
let turns () =
  let in_turn = List.sort Int.compare (List.map Part.turn Part.all) in
  Alcotest.(check (list int)) "each in turn" Part.all in_turn;
  List.iter
    (fun n ->
      let first = List.filter (fun i -> Part.turn i < n) Part.all in
      let area = 61. /. float_of_int n in
      if distance_to first > 0.25 *. area then
        Alcotest.failf "the first %d: %g" n (distance_to first))
    [ 1; 2; 3; 5; 8; 13; 20; 30; 45; 60 ]

let suite =
  ( "parts",
    [
      law "rows, columns and diagonals meet all of them in turn" meets_all;
      law "a part is judged by all but itself and those that it advises"
        not_asked;
      Law.law
        ~print:(fun { Window.x0; y0; x1; y1 } ->
          Printf.sprintf "%d,%d,%d,%d" x0 y0 x1 y1)
        "a window has the parts of its pixels" window counted;
      Law.example "the first few in turn lie evenly in the picture" turns;
    ] )
