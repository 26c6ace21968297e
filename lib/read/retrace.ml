open Candor_scene
module Lines = Map.Make (Int)

(* [wanted] are lines in order, the others above [line] or at it. *)
type scan = { line : int; wanted : int list; starts : int Lines.t }

let take start s =
  match s.wanted with
  | line :: wanted when Int.equal line s.line ->
      { s with wanted; starts = Lines.add line start s.starts }
  | [] | _ :: _ -> s

let rec scan_text text ~first from s =
  match String.index_from_opt text from '\n' with
  | Some n when not (List.is_empty s.wanted) ->
      take (first + n + 1) { s with line = s.line + 1 }
      |> scan_text text ~first (n + 1)
  | Some _ | None -> s

let starts source lines =
  let rec scan first s =
    match Source.slice source ~first ~last:max_int with
    | "" -> s.starts
    | _ when List.is_empty s.wanted -> s.starts
    | text -> scan (first + String.length text) (scan_text text ~first 0 s)
  in
  let wanted = List.sort_uniq Int.compare lines in
  scan 0 (take 0 { line = 1; wanted; starts = Lines.empty })

let longest_head = 100

let is_head = function
  | ' ' | '\t' | '\n' | '\r' | '(' | ')' | '"' | ';' -> false
  | _ -> true

(* The bytes to skip and to underline in a form's text: its head, if that stands
   at once behind the parenthesis. *)
let mark_of text =
  let rec last i =
    if i < String.length text && is_head text.[i] then last (i + 1) else i
  in
  if String.starts_with ~prefix:"(" text && last 1 > 1 then (1, last 1 - 1)
  else (0, 1)

let spans source places =
  let starts = starts source (List.map (fun (p : Place.t) -> p.line) places) in
  fun { Place.line; column; file = _ } ->
    let span start =
      let offset = start + column - 1 in
      let text =
        Source.slice source ~first:offset ~last:(offset + longest_head)
      in
      let mark, width = mark_of text in
      { Span.line; column; offset; mark; width }
    in
    Option.map span (Lines.find_opt line starts)
