(** Flat polygons in exact arithmetic: what their outline winds around, ties
    broken as for {!Exact_triangle}. *)

open Candor_space

(* The triangles that the first corner makes with every side. Counted with their
   orientation they wind as the outline does. *)
let fan corners =
  match corners with
  | [] -> []
  | a :: rest ->
      let rec go = function
        | b :: (c :: _ as rest) -> (a, b, c) :: go rest
        | [ _ ] | [] -> []
      in
      go rest

let area triangles =
  let open Dyadic_vec in
  List.fold_left
    (fun n (a, b, c) -> add n (cross (sub b a) (sub c a)))
    (of_floats 0. 0. 0.) triangles

let turns d (a, b, c) =
  let first = Exact_triangle.edge d b c in
  if Exact_triangle.edge d c a = first && Exact_triangle.edge d a b = first then
    first
  else 0

(** [truth_along corners line] is where [line] crosses the polygon with these
    corners, which must lie in a plane exactly. *)
let truth_along corners (line : Line.t) =
  let d = line.direction in
  let seen p = Dyadic_vec.neg (Line.from line (Dyadic_vec.point p)) in
  let triangles = fan (List.map seen corners) in
  let n = area triangles in
  let across = Dyadic_vec.dot d n in
  let winding = List.fold_left (fun w t -> w + turns d t) 0 triangles in
  match triangles with
  | (a, _, _) :: _ when winding <> 0 && Dyadic.sign across <> 0 ->
      let side : Side.t = if Dyadic.sign across < 0 then Outside else Inside in
      let at = Exact_root.ratio (Dyadic_vec.dot a n) across in
      Crossing.exactly [ { at; side; part = 0 } ]
  | _ -> Crossing.exactly []
