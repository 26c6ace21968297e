open Candor_render
open Candor_oracle
open QCheck2

let place = Gen.(pair (int_range (-1000) 1000) (int_range (-1000) 1000))
let print (x, y) = Printf.sprintf "%d %d" x y
let law name f = Law.law ~print name place f

(* Along a row, a column and both diagonals. *)
let meets_all (x, y) =
  let along (dx, dy) =
    List.map (fun k -> Fifth.of_pixel (x + (k * dx)) (y + (k * dy))) Fifth.all
    |> List.sort Int.compare
  in
  List.for_all
    (fun step -> along step = Fifth.all)
    [ (1, 0); (0, 1); (1, 1); (1, -1) ]

let not_asked () =
  let judges i =
    let a, b = Fifth.judges i in
    [ a; b ]
  in
  List.iter
    (fun i ->
      let theirs = List.concat_map judges (judges i) in
      Alcotest.(check int)
        "two judges" 2
        (List.length (List.sort_uniq Int.compare (judges i)));
      Alcotest.(check bool) "not itself" false (List.mem i (judges i));
      Alcotest.(check bool) "not theirs" false (List.mem i theirs))
    Fifth.all

let suite =
  ( "fifths",
    [
      law "rows, columns and diagonals meet all five in turn" meets_all;
      Law.example "nobody is judged by itself, nor by who asks it" not_asked;
    ] )
