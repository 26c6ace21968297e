let least a b c = Int.min a (Int.min b c)

(* Row [i] of the table holds the distances from the first [i] letters of [a] to
   each prefix of [b]; [above] are the two rows before it. *)
let row a b i ~above:(last, before_last) =
  let n = String.length b in
  let cells = Array.make (n + 1) i in
  (* local mutation: one row, filled from the left *)
  for j = 1 to n do
    let differs = if Char.equal a.[i - 1] b.[j - 1] then 0 else 1 in
    let edited =
      least (last.(j) + 1) (cells.(j - 1) + 1) (last.(j - 1) + differs)
    in
    let swapped =
      i > 1 && j > 1
      && Char.equal a.[i - 1] b.[j - 2]
      && Char.equal a.[i - 2] b.[j - 1]
    in
    cells.(j) <-
      (if swapped then Int.min edited (before_last.(j - 2) + 1) else edited)
  done;
  cells

let distance ~most a b =
  let m = String.length a and n = String.length b in
  if Int.abs (m - n) > most then most + 1
  else
    let rec fill i ((last, _) as above) =
      if i > m then Int.min last.(n) (most + 1)
      else fill (i + 1) (row a b i ~above, last)
    in
    let first = Array.init (n + 1) Fun.id in
    fill 1 (first, first)

let nearest word ~among =
  let letters = String.length word in
  let most = if letters > 60 then 0 else Int.min 2 (letters / 2) in
  let nearer best candidate =
    let d = distance ~most word candidate in
    match best with
    | Some (least, _) when least <= d -> best
    | Some _ | None -> if 0 < d && d <= most then Some (d, candidate) else best
  in
  Seq.take 1000 (List.to_seq among)
  |> Seq.fold_left nearer None |> Option.map snd

let hint word ~among =
  let ask meant = "did you mean " ^ Quote.word meant ^ "?" in
  Option.map ask (nearest word ~among)
