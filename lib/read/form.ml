type t = { head : string; span : Span.t; body : Located.t list }

let title head =
  if String.equal head "" then "this list" else "(" ^ head ^ " ...)"

let synopsis head arguments =
  "(" ^ head
  ^ (if String.equal head "" || String.equal arguments "" then "" else " ")
  ^ arguments ^ ")"

let of_located (s : Located.t) =
  match s.node with
  | List ({ node = Atom head; _ } :: body) -> Some { head; span = s.span; body }
  | List ([] | { node = List _; _ } :: _) | Atom _ -> None

let quote (s : Located.t) =
  match (s.node, Located.head s) with
  | Atom a, _ -> Quote.word a
  | List _, Some head -> title (Quote.brief head)
  | List [], None -> "()"
  | List (_ :: _), None -> "a list"

let found form =
  let is_atom (s : Located.t) =
    match s.node with Atom _ -> true | List _ -> false
  in
  match List.length form.body with
  | 0 -> "nothing"
  | n when List.for_all is_atom form.body -> Quote.count n "word"
  | n -> Quote.count n "item"

let unexpected word ~among =
  match Spelling.hint word ~among with
  | Some _ as hint -> hint
  | None when List.is_empty among || List.compare_length_with among 12 > 0 ->
      None
  | None -> Some ("expected " ^ Quote.list among)
