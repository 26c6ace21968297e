type point = { seconds : float; error : float }

let known x = if Float.is_nan x then infinity else x

let beats a b =
  let a_seconds = known a.seconds
  and a_error = known a.error
  and b_seconds = known b.seconds
  and b_error = known b.error in
  a_seconds <= b_seconds && a_error <= b_error
  && (a_seconds < b_seconds || a_error < b_error)

let pareto points =
  List.map (fun p -> not (List.exists (fun q -> beats q p) points)) points

let range f points =
  let values = List.map f points in
  ( List.fold_left Float.min infinity values,
    List.fold_left Float.max neg_infinity values )

let knee points =
  let quick, slow = range (fun p -> p.seconds) points
  and fine, coarse = range (fun p -> p.error) points in
  let below p =
    ((coarse -. p.error) /. (coarse -. fine))
    -. ((p.seconds -. quick) /. (slow -. quick))
  in
  let better best (i, depth) =
    match best with
    | Some (_, deepest) when depth <= deepest -> best
    | Some _ | None -> if depth > 0. then Some (i, depth) else best
  in
  List.mapi (fun i p -> (i, below p)) points
  |> List.fold_left better None |> Option.map fst
