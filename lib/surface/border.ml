type edge = { left : Flat.t; right : Flat.t }

let turn e p = Flat.turn e.left e.right p
let ends e p = Flat.equal p e.left || Flat.equal p e.right

(* By left end, then counter-clockwise, then the shorter first. *)
let order e f =
  match Flat.(compare e.left f.left, compare e.right f.right) with
  | 0, 0 -> 0
  | 0, reach -> ( match -turn e f.right with 0 -> reach | order -> order)
  | order, _ -> order

module Spots = Set.Make (Flat)

module Edges = Map.Make (struct
  type t = edge

  let compare = order
end)

(* {1 Windings: how many more times each edge is passed to the right than to the
   left} *)

let pass n windings (a, b) =
  let edge, n =
    if Flat.compare a b < 0 then ({ left = a; right = b }, n)
    else ({ left = b; right = a }, -n)
  in
  let add m =
    match n + Option.value m ~default:0 with 0 -> None | n -> Some n
  in
  if Flat.equal a b then windings else Edges.update edge add windings

let rec steps = function
  | a :: (b :: _ as rest) -> (a, b) :: steps rest
  | [] | [ _ ] -> []

(* Every edge, from the left, with the earlier ones that reach beyond its left
   end. *)
let sweep windings =
  let step (earlier, later) =
    match later () with
    | Seq.Nil -> None
    | Seq.Cons (((e, _) as item), later) ->
        let reaches (f, _) = Flat.compare e.left f.right < 0 in
        let earlier = List.filter reaches earlier in
        Some ((item, earlier), (item :: earlier, later))
  in
  Seq.unfold step ([], Edges.to_seq windings)

(* {1 Cutting edges where they meet} *)

let apart e f =
  let top e = Float.max e.left.Flat.v e.right.v
  and bottom e = Float.min e.left.Flat.v e.right.v in
  top e < bottom f || top f < bottom e

let pairs windings =
  let meets ((e, _), earlier) =
    let near (f, _) = if apart e f then None else Some (e, f) in
    List.to_seq (List.filter_map near earlier)
  in
  Seq.concat_map meets (sweep windings)

let cross (e, f) =
  turn e f.left * turn e f.right < 0 && turn f e.left * turn f e.right < 0

(* The order of spots along an edge: by the coordinate in which it is longer,
   where rounding disturbs it least. *)
let along { left = a; right = b } (p : Flat.t) (q : Flat.t) =
  let by_u = Float.compare a.u b.u * Float.compare q.u p.u
  and by_v = Float.compare a.v b.v * Float.compare q.v p.v in
  let first, second =
    if Float.abs (b.u -. a.u) < Float.abs (b.v -. a.v) then (by_v, by_u)
    else (by_u, by_v)
  in
  if first = 0 then second else first

let cut windings cuts =
  let replace e n parts =
    let spots = Option.value (Edges.find_opt e cuts) ~default:[] in
    let way = (e.left :: List.sort_uniq (along e) spots) @ [ e.right ] in
    List.fold_left (pass n) parts (steps way)
  in
  if Edges.is_empty cuts then windings
  else Edges.fold replace windings Edges.empty

let cut_touching windings =
  let on e p =
    Flat.compare e.left p < 0 && Flat.compare p e.right < 0 && turn e p = 0
  in
  let touch cuts (e, f) =
    let add e cuts p = if on e p then Edges.add_to_list e p cuts else cuts in
    let cuts = List.fold_left (add e) cuts [ f.left; f.right ] in
    List.fold_left (add f) cuts [ e.left; e.right ]
  in
  cut windings (Seq.fold_left touch Edges.empty (pairs windings))

(* {1 Snapping to the grid} *)

(* The one that stands for all that are seen in the same spot. *)
let spot known p = Option.value (Spots.find_opt p known) ~default:p

let moved_to_grid windings =
  let place p spots = Spots.add (Flat.to_grid p) spots in
  let ends e _ spots = place e.left (place e.right spots) in
  let spots = Edges.fold ends windings Spots.empty in
  let on_grid p = spot spots (Flat.to_grid p) in
  let move e n moved = pass n moved (on_grid e.left, on_grid e.right) in
  (spots, Edges.fold move windings Edges.empty)

let entered spots e =
  let reached (p : Flat.t) = e.left.u <= p.u in
  let before (p : Flat.t) = p.u <= e.right.u in
  let enters p = Flat.enters (e.left, e.right) p in
  match Spots.find_first_opt reached spots with
  | None -> []
  | Some p ->
      Spots.to_seq_from p spots |> Seq.take_while before |> Seq.filter enters
      |> List.of_seq

(* Edges are cut in every square that they enter and that holds a spot; and
   where they cross, in case that was rounded into the next square. *)
let snap view windings =
  let spots, windings = moved_to_grid windings in
  let crossing (e, f) =
    ([ e; f ], Flat.crossing view (e.left, e.right) (f.left, f.right))
  in
  let crossings =
    List.of_seq (Seq.map crossing (Seq.filter cross (pairs windings)))
  in
  let add spots (_, p) = Spots.add p spots in
  let spots = List.fold_left add spots crossings in
  let add p cuts e = if ends e p then cuts else Edges.add_to_list e p cuts in
  let bend cuts (edges, p) = List.fold_left (add (spot spots p)) cuts edges in
  let cuts = List.fold_left bend Edges.empty crossings in
  let enter e _ cuts =
    List.fold_left (fun cuts p -> add p cuts e) cuts (entered spots e)
  in
  cut windings (Edges.fold enter windings cuts)

(* One snap leaves nothing that crosses, but for crossings rounded the other way.
   In any case this ends: it cuts into edges of smaller bounds, on a grid. *)
let rec settle view windings =
  if Seq.exists cross (pairs windings) then settle view (snap view windings)
  else cut_touching windings

let of_outline view corners =
  let spots = Spots.of_list corners in
  let corners = List.map (spot spots) corners in
  let closed =
    match corners with [] -> [] | first :: _ -> corners @ [ first ]
  in
  let windings = List.fold_left (pass 1) Edges.empty (steps closed) in
  let parts ((e, n), earlier) =
    let under (f, _) = turn f e.left >= 0 in
    let add sum (_, n) = sum + n in
    let below = List.fold_left add 0 (List.filter under earlier) in
    if below <> 0 = (below + n <> 0) then None else Some e
  in
  List.of_seq (Seq.filter_map parts (sweep (settle view windings)))
