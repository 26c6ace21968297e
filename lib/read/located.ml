open Parsexp

type t = { span : Span.t; node : node }
and node = Atom of string | List of t list

(* Readers of a scene recur on its lists, and each minor collection looks at all
   of the stack. *)
let deepest = 200_000

exception Too_deep of Span.t

let span_of_list (paren : Span.t) items =
  match items with
  | { span; node = Atom _ } :: _ when Int.equal span.line paren.line ->
      { paren with mark = span.offset - paren.offset; width = span.width }
  | [] | { node = Atom _ | List _; _ } :: _ -> paren

let rec locate ~depth places (sexp : Sexplib0.Sexp.t) =
  let next () = Positions.Iterator.advance_exn places ~skip:0 in
  let span = Span.of_position (next ()) in
  match sexp with
  | Atom a ->
      let last = next () in
      {
        span = { span with width = last.offset - span.offset + 1 };
        node = Atom a;
      }
  | List _ when depth > deepest -> raise_notrace (Too_deep span)
  | List l ->
      let items = List.map (locate ~depth:(depth + 1) places) l in
      let (_ : Positions.pos) = next () in
      { span = span_of_list span items; node = List items }

let of_parsed (sexp, positions) =
  match locate ~depth:0 (Positions.Iterator.create positions) sexp with
  | located -> Ok located
  | exception Too_deep span ->
      Error (span, "lists are nested more than 200,000 deep")

let head s =
  match s.node with
  | List ({ node = Atom head; _ } :: _) -> Some head
  | List ([] | { node = List _; _ } :: _) | Atom _ -> None
