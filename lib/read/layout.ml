type t = { node : node; width : int }
and node = Atom of string | List of t list

let columns = 80
let deepest_indent = 40

let atom s =
  let text = Sexplib0.Sexp.to_string (Atom s) in
  { node = Atom text; width = String.length text }

(* Two parentheses, and a space before every item but the first. *)
let list items =
  let add width s = width + 1 + s.width in
  { node = List items; width = Int.max 2 (List.fold_left add 1 items) }

let form head body = list (atom head :: body)

let rec add_flat b s =
  match s.node with
  | Atom a -> Buffer.add_string b a
  | List items ->
      Buffer.add_char b '(';
      List.iteri
        (fun i item ->
          if i > 0 then Buffer.add_char b ' ';
          add_flat b item)
        items;
      Buffer.add_char b ')'

let new_line b indent =
  Buffer.add_char b '\n';
  Buffer.add_string b (String.make indent ' ')

(* [after] is how many parentheses close right behind. *)
let rec add_within b ~indent ~after s =
  match s.node with
  | Atom a -> Buffer.add_string b a
  | List _ when indent + s.width + after <= columns -> add_flat b s
  | List items ->
      Buffer.add_char b '(';
      add_items b ~indent ~after items;
      Buffer.add_char b ')'

and add_items b ~indent ~after items =
  let within = Int.min deepest_indent (indent + 2) in
  let rec go ~column = function
    | [] -> ()
    | item :: rest ->
        let after = if List.is_empty rest then after + 1 else 0 in
        let fits = column + 1 + item.width + after <= columns in
        let column =
          match item.node with
          | Atom _ when column = indent + 1 || fits ->
              if column > indent + 1 then Buffer.add_char b ' ';
              column + 1
          | Atom _ | List _ ->
              new_line b within;
              within
        in
        add_within b ~indent:within ~after item;
        go ~column:(column + item.width) rest
  in
  go ~column:(indent + 1) items

let add b ~indent s = add_within b ~indent ~after:0 s
