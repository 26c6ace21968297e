open Border

(* What is filled between two neighbouring edges, as far as no triangle covers
   it yet. [chain] is its left border, from the left end of [lower] to that of
   [upper]. It nowhere turns towards the inside: whatever it could spare has
   been cut off. Its rightmost vertex is the latest one between the edges. *)
type gap = { lower : edge; upper : edge; chain : Flat.t list }

let above w e = Flat.turn e.left e.right w > 0
let under w e = Flat.turn e.left e.right w < 0
let ends w e = Flat.equal w e.right

(* The chain, from the given end on, that is left once [w] has been joined to
   all it sees; [w] comes after its lower end, or before its upper one. *)
let rec cut_lower w found = function
  | a :: (b :: _ as rest) when Flat.turn a w b > 0 ->
      cut_lower w ((a, w, b) :: found) rest
  | chain -> (chain, found)

let rec cut_upper w found = function
  | a :: (b :: _ as rest) when Flat.turn a b w > 0 ->
      cut_upper w ((a, b, w) :: found) rest
  | chain -> (chain, found)

(* The chain up to its rightmost vertex, back from there, and from there on. *)
let rec parted back = function
  | a :: (b :: _ as rest) when Flat.compare a b < 0 -> parted (a :: back) rest
  | tip :: rest -> (tip :: back, tip :: rest)
  | [] -> (back, [])

(* What [w] leaves of the gaps that touch it: one under it, one over it. *)
let touch w (under, over, found) gap =
  let cut_under chain found =
    let chain, found = cut_upper w found chain in
    (Some (gap.lower, chain), found)
  and cut_over chain found =
    let chain, found = cut_lower w found chain in
    (Some (chain, gap.upper), found)
  in
  match (ends w gap.lower, ends w gap.upper) with
  | true, true -> (under, over, snd (cut_lower w found gap.chain))
  | false, true ->
      let under, found = cut_under (List.rev gap.chain) found in
      (under, over, found)
  | true, false ->
      let over, found = cut_over gap.chain found in
      (under, over, found)
  | false, false ->
      let back, on = parted [] gap.chain in
      let under, found = cut_under back found in
      let over, found = cut_over on found in
      (under, over, found)

(* The gaps to the right of [w], given the edges that start there. *)
let rec gaps_from w under starts over =
  match (under, starts, over) with
  | None, lower :: rest, _ -> gaps_from w (Some (lower, [])) rest over
  | Some (lower, back), upper :: rest, _ ->
      let gap = { lower; upper; chain = List.rev (w :: back) } in
      gap :: gaps_from w None rest over
  | Some (lower, back), [], Some (on, upper) ->
      [ { lower; upper; chain = List.rev_append back (w :: on) } ]
  | Some _, [], None | None, [], Some _ | None, [], None -> []

let pass (gaps, found) (w, starts) =
  let lies_under gap = (not (ends w gap.upper)) && above w gap.upper in
  let lies_over gap = (not (ends w gap.lower)) && under w gap.lower in
  let low, rest = List.partition lies_under gaps in
  let high, touched = List.partition lies_over rest in
  let under, over, found =
    List.fold_left (touch w) (None, None, found) touched
  in
  (low @ gaps_from w under starts over @ high, found)

module Events = Map.Make (Flat)

let triangles border =
  let event events e =
    let also starts = Some (Option.value starts ~default:[]) in
    Events.update e.right also (Events.add_to_list e.left e events)
  in
  let events = List.fold_left event Events.empty (List.rev border) in
  let _, found = Seq.fold_left pass ([], []) (Events.to_seq events) in
  List.rev found
