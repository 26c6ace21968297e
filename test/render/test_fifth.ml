open Candor_render
open Candor_oracle
open QCheck2

let place = Gen.(pair (int_range (-1000) 1000) (int_range (-1000) 1000))
let print (x, y) = Printf.sprintf "%d %d" x y
let law name f = Law.law ~print name place f
let all = List.init Fifth.count Fun.id

(* Along a row, a column and both diagonals. *)
let meets_all (x, y) =
  let along (dx, dy) =
    List.map (fun k -> Fifth.of_pixel (x + (k * dx)) (y + (k * dy))) all
    |> List.sort Int.compare
  in
  List.for_all
    (fun step -> along step = all)
    [ (1, 0); (0, 1); (1, 1); (1, -1) ]

let not_asked () =
  List.iter
    (fun i ->
      let judges = List.filter (fun j -> Fifth.is_judge j ~of_:i) all in
      let a, b = Fifth.judges i in
      Alcotest.(check (list int))
        "two judges" judges
        (List.sort Int.compare [ a; b ]);
      Alcotest.(check bool) "not itself" false (Fifth.is_judge i ~of_:i);
      let is_asked j = Fifth.is_judge i ~of_:j in
      Alcotest.(check bool) "not theirs" false (List.exists is_asked judges))
    all

let suite =
  ( "fifths",
    [
      law "rows, columns and diagonals meet all five in turn" meets_all;
      Law.example "nobody is judged by itself, nor by who asks it" not_asked;
    ] )
