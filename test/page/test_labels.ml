open Candor_cost
open Candor_oracle
open QCheck2

let frame = { Labels.left = 0.; top = 0.; width = 300.; height = 200. }

let wish =
  let open Gen in
  let+ x = float_range 0. 300.
  and+ y = float_range 0. 200.
  and+ text = Hostile.any [ "1"; "64"; "the knee" ] in
  { Labels.mark = (x, y); clear = 5.; text; style = "k" }

let place wishes =
  let around (w : Labels.wish) = Labels.around w.mark 5. in
  Labels.place ~size:13. ~within:frame ~taken:(List.map around wishes) wishes

(* A letter is at least half as wide as high. *)
let box (l : Labels.t) =
  let width = 6.5 *. float_of_int (String.length l.says) in
  let x, y = l.at in
  let left =
    match l.anchor with
    | Start -> x
    | Middle -> x -. (width /. 2.)
    | End -> x -. width
  in
  (left, y -. 10., left +. width, y)

let overlap (a, b, c, d) (a', b', c', d') = a < c' && a' < c && b < d' && b' < d

let rec apart = function
  | [] -> true
  | b :: rest -> (not (List.exists (overlap b) rest)) && apart rest

let free wishes =
  let marks =
    List.map
      (fun (w : Labels.wish) ->
        let x, y = w.mark in
        (x -. 4.9, y -. 4.9, x +. 4.9, y +. 4.9))
      wishes
  in
  let boxes = List.map box (place wishes) in
  let inside (a, b, c, d) = a >= 0. && b >= 0. && c <= 300. && d <= 200. in
  let off b = not (List.exists (overlap b) marks) in
  apart boxes && List.for_all inside boxes && List.for_all off boxes

let alone () =
  let wish mark = { Labels.mark; clear = 5.; text = "16"; style = "k" } in
  let placed mark = List.length (place [ wish mark ]) in
  Alcotest.(check int) "amid" 1 (placed (150., 100.));
  Alcotest.(check int) "in a corner" 1 (placed (299., 1.));
  Alcotest.(check int) "nowhere" 0 (placed (nan, 1.))

let print wishes =
  Print.list (fun (w : Labels.wish) -> Print.(pair float float) w.mark) wishes

let suite =
  ( "labels",
    [
      Law.law ~print ~count:500 "they keep off each other and off all marks"
        Gen.(list_size (int_bound 20) wish)
        free;
      Law.example "a mark alone has its label" alone;
    ] )
