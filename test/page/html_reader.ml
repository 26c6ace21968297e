(* The strictest HTML that suffices for what Candor writes: all elements but the
   void ones are closed, in order, all values are quoted, none is given twice. *)

type tag = { name : string; attributes : (string * string) list }
type event = Open of tag | Close of string | Text of string

exception Wrong of string

let wrong format = Printf.ksprintf (fun why -> raise (Wrong why)) format
let voids = [ "meta"; "img"; "br"; "link"; "hr" ]

let is_name c =
  match c with 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '-' -> true | _ -> false

let rec name_end s i = if is_name s.[i] then name_end s (i + 1) else i

let unescape s =
  let named = [ ("amp", "&"); ("lt", "<"); ("gt", ">"); ("quot", "\"") ] in
  match String.split_on_char '&' s with
  | [] -> ""
  | first :: rest ->
      let one part =
        match String.index_opt part ';' with
        | None -> wrong "a bare ampersand before %S" part
        | Some i -> (
            match List.assoc_opt (String.sub part 0 i) named with
            | None -> wrong "an unknown character &%s" part
            | Some c -> c ^ String.sub part (i + 1) (String.length part - i - 1)
            )
      in
      String.concat "" (first :: List.map one rest)

let plain s =
  String.iter
    (fun c -> if c = '<' || c = '>' || c = '"' then wrong "%C in %S" c s)
    s;
  unescape s

let rec attributes s i known =
  if s.[i] = '>' then (List.rev known, i + 1)
  else if s.[i] <> ' ' then wrong "%C in a tag" s.[i]
  else
    let eq = name_end s (i + 1) in
    let name = String.sub s (i + 1) (eq - i - 1) in
    if name = "" || s.[eq] <> '=' || s.[eq + 1] <> '"' then
      wrong "a bad attribute %S" name;
    if List.mem_assoc name known then wrong "%s is given twice" name;
    let quote = String.index_from s (eq + 2) '"' in
    let value = plain (String.sub s (eq + 2) (quote - eq - 2)) in
    attributes s (quote + 1) ((name, value) :: known)

let rec events s i stack seen =
  if i = String.length s then
    match stack with
    | [] -> List.rev seen
    | name :: _ -> wrong "%s is left open" name
  else if s.[i] <> '<' then begin
    let until =
      Option.value ~default:(String.length s) (String.index_from_opt s i '<')
    in
    let text = plain (String.sub s i (until - i)) in
    events s until stack (Text text :: seen)
  end
  else if s.[i + 1] = '/' then
    let last = name_end s (i + 2) in
    let name = String.sub s (i + 2) (last - i - 2) in
    match stack with
    | top :: rest when top = name && s.[last] = '>' ->
        events s (last + 1) rest (Close name :: seen)
    | _ -> wrong "%s is closed out of order" name
  else
    let last = name_end s (i + 1) in
    let name = String.sub s (i + 1) (last - i - 1) in
    if name = "" then wrong "a tag without a name at %d" i;
    let attributes, next = attributes s last [] in
    let stack = if List.mem name voids then stack else name :: stack in
    events s next stack (Open { name; attributes } :: seen)

let doctype = "<!DOCTYPE html>\n"

(* What a document consists of, or what is wrong with it. *)
let read s =
  if not (String.starts_with ~prefix:doctype s) then Error "no doctype"
  else
    match events s (String.length doctype) [] [] with
    | events -> Ok events
    | exception Wrong why -> Error why
    | exception (Invalid_argument _ | Not_found) -> Error "it ends early"
