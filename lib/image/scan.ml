type t = { text : string; mutable at : int }

let v text = { text; at = 0 }
let left s = String.length s.text - s.at

let ends_word = function
  | ' ' | '\t' | '\n' | '\011' | '\012' | '\r' | '#' -> true
  | _ -> false

let skip_line s =
  s.at <-
    (match String.index_from_opt s.text s.at '\n' with
    | Some newline -> newline + 1
    | None -> String.length s.text)

let rec skip_blanks s =
  if left s > 0 && ends_word s.text.[s.at] then begin
    if s.text.[s.at] = '#' then skip_line s else s.at <- s.at + 1;
    skip_blanks s
  end

let word s =
  skip_blanks s;
  let first = s.at in
  while left s > 0 && not (ends_word s.text.[s.at]) do
    s.at <- s.at + 1
  done;
  String.sub s.text first (s.at - first)

let is_digit c = c >= '0' && c <= '9'
let clip w = if String.length w <= 20 then w else String.sub w 0 20 ^ "..."

let number s what =
  match word s with
  | "" -> Error (Printf.sprintf "the file ends where %s is expected" what)
  | w when String.length w <= 9 && String.for_all is_digit w ->
      Ok (int_of_string w)
  | w -> Error (Printf.sprintf "expected %s, found %S" what (clip w))

let ends_early ~needed ~left =
  Printf.sprintf
    "the file ends early: its pixels need %d more bytes, %d are there" needed
    left

let body s ~bytes =
  if left s > 0 then
    if s.text.[s.at] = '#' then skip_line s else s.at <- s.at + 1;
  if left s >= bytes then Ok s.at
  else Error (ends_early ~needed:bytes ~left:(left s))
