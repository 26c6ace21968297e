type t = { text : string; mutable at : int; mutable line : int }

exception Refused of string

let reading f text =
  match f { text; at = 0; line = 1 } with
  | x -> Ok x
  | exception Refused why -> Error why

let refuse t why =
  raise_notrace (Refused (Printf.sprintf "line %d: %s" t.line why))

let left t = String.length t.text - t.at
let is_over t = left t <= 0

let is_blank = function
  | ' ' | '\t' | '\r' | '\011' | '\012' -> true
  | _ -> false

let is_at t i c = i < String.length t.text && Char.equal t.text.[i] c

(* The offset after a line's end that is to be passed over. *)
let joined t =
  if not (is_at t t.at '\\') then None
  else if is_at t (t.at + 1) '\n' then Some (t.at + 2)
  else if is_at t (t.at + 1) '\r' && is_at t (t.at + 2) '\n' then Some (t.at + 3)
  else None

let rec skip_blanks t =
  if left t > 0 then
    if is_blank t.text.[t.at] then (
      t.at <- t.at + 1;
      skip_blanks t)
    else
      match joined t with
      | None -> ()
      | Some next ->
          t.at <- next;
          t.line <- t.line + 1;
          skip_blanks t

let rec word_end t i =
  if i >= String.length t.text then i
  else
    match t.text.[i] with
    | '\n' -> i
    | c -> if is_blank c then i else word_end t (i + 1)

let word t =
  skip_blanks t;
  let first = t.at in
  t.at <- word_end t first;
  String.sub t.text first (t.at - first)

let need t what =
  match word t with
  | "" -> refuse t (Printf.sprintf "expected %s, not the end of the line" what)
  | word -> word

let length t what =
  match Number.of_string (need t what) with
  | Ok x when Candor_surface.Reach.length x -> x
  | Ok _ -> refuse t Candor_surface.Reach.message
  | Error why -> refuse t why

let next_line t =
  match String.index_from_opt t.text t.at '\n' with
  | Some newline ->
      t.at <- newline + 1;
      t.line <- t.line + 1
  | None -> t.at <- String.length t.text

let take t n =
  let at = t.at in
  t.at <- at + n;
  at

let is_blank_line t =
  skip_blanks t;
  is_over t || Char.equal t.text.[t.at] '\n'
