module Names = Map.Make (String)

type mark = Open | Done

(* What a search has come to. *)
type search = { marks : mark Names.t; cycles : string list list }

(* The part of [path], innermost first, from its end to [name]. *)
let rec around name = function
  | [] -> []
  | last :: _ when String.equal last name -> [ last ]
  | last :: path -> last :: around name path

let rec visit edges path search name =
  match (Names.find_opt name search.marks, Names.find_opt name edges) with
  | Some Done, _ | None, None -> search
  | Some Open, _ ->
      let cycle = List.rev (name :: around name path) in
      { search with cycles = cycle :: search.cycles }
  | None, Some next ->
      let mark m search =
        { search with marks = Names.add name m search.marks }
      in
      List.fold_left (visit edges (name :: path)) (mark Open search) next
      |> mark Done

let all edges =
  let table = Names.of_seq (List.to_seq edges) in
  let visit search (name, _) = visit table [] search name in
  let none = { marks = Names.empty; cycles = [] } in
  List.rev (List.fold_left visit none edges).cycles
