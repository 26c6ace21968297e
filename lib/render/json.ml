type t =
  | Null
  | Bool of bool
  | Int of int
  | Float of float
  | String of string
  | List of t list
  | Object of (string * t) list

let escaped c =
  match c with
  | '"' -> "\\\""
  | '\\' -> "\\\\"
  | '\n' -> "\\n"
  | c when Char.code c < 0x20 -> Printf.sprintf "\\u%04x" (Char.code c)
  | c -> String.make 1 c

let quoted s =
  (* Bytes that are not UTF-8 would make the text invalid. *)
  let valid = String.is_valid_utf_8 s in
  let safe c = if valid || Char.code c < 0x80 then c else '?' in
  let escape s c = s ^ escaped (safe c) in
  "\"" ^ String.fold_left escape "" s ^ "\""

let number x =
  if not (Float.is_finite x) then "null"
  else
    let short = Printf.sprintf "%.15g" x in
    if Float.equal (float_of_string short) x then short
    else Printf.sprintf "%.17g" x

let rec lines indent j =
  let deeper = indent ^ "  " in
  let block left right items =
    Printf.sprintf "%s\n%s%s\n%s%s" left deeper
      (String.concat (",\n" ^ deeper) items)
      indent right
  in
  match j with
  | Null -> "null"
  | Bool b -> string_of_bool b
  | Int n -> string_of_int n
  | Float x -> number x
  | String s -> quoted s
  | List [] -> "[]"
  | Object [] -> "{}"
  | List items -> block "[" "]" (List.map (lines deeper) items)
  | Object fields ->
      let field (name, value) =
        Printf.sprintf "%s: %s" (quoted name) (lines deeper value)
      in
      block "{" "}" (List.map field fields)

let to_string j = lines "" j ^ "\n"
