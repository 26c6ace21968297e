open Candor_read
open Text

let check name edges expected =
  Alcotest.(check (list (list string))) name expected (Cycles.all edges)

let cycles () =
  check "none" [ ("a", [ "b"; "c" ]); ("b", [ "c" ]); ("c", []) ] [];
  check "unknown" [ ("a", [ "z" ]) ] [];
  check "itself" [ ("a", [ "a" ]) ] [ [ "a"; "a" ] ];
  check "two"
    [ ("a", [ "b" ]); ("b", [ "a" ]); ("c", [ "d" ]); ("d", [ "c"; "a" ]) ]
    [ [ "a"; "b"; "a" ]; [ "c"; "d"; "c" ] ];
  check "behind a lead"
    [ ("a", [ "b" ]); ("b", [ "c" ]); ("c", [ "b" ]) ]
    [ [ "b"; "c"; "b" ] ]

let long () =
  let n = 100_000 in
  let edge i = (string_of_int i, [ string_of_int ((i + 1) mod n) ]) in
  match Cycles.all (List.init n edge) with
  | [ cycle ] -> Alcotest.(check int) "length" (n + 1) (List.length cycle)
  | cycles -> Alcotest.failf "%d cycles" (List.length cycles)

let gen =
  let name = QCheck2.Gen.(map string_of_int (int_range 0 5)) in
  QCheck2.Gen.(
    map
      (List.mapi (fun i next -> (string_of_int i, next)))
      (list_size (return 6) (list_size (int_range 0 2) name)))

(* A name is in a cycle iff it can be reached from itself. *)
let reach edges =
  let rec go seen name =
    List.fold_left
      (fun seen next ->
        if List.mem next seen then seen else go (next :: seen) next)
      seen (List.assoc name edges)
  in
  List.exists (fun (name, _) -> List.mem name (go [] name)) edges

let found =
  law ~count:2000 "there is a cycle iff some name leads back to itself" gen
    (fun edges -> reach edges = (Cycles.all edges <> []))

let real =
  law ~count:2000 "each cycle leads along edges back to its start" gen
    (fun edges ->
      let rec follows = function
        | a :: (b :: _ as rest) ->
            List.mem b (List.assoc a edges) && follows rest
        | [ _ ] | [] -> true
      in
      List.for_all
        (fun cycle -> follows cycle && List.hd cycle = List.hd (List.rev cycle))
        (Cycles.all edges))

let suite =
  ( "cycles",
    [
      case "cycles are found where there are any" cycles;
      case "a cycle of a hundred thousand names is found" long;
      found;
      real;
    ] )
