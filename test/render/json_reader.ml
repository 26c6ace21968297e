(** A reader of JSON by the letter of RFC 8259, independent of what writes it.
    Numbers stay as they are written. *)

type t =
  | Null
  | Bool of bool
  | Number of string
  | String of string
  | List of t list
  | Object of (string * t) list

exception Wrong of int

let read text =
  let n = String.length text in
  let at = ref 0 in
  let wrong () = raise (Wrong !at) in
  let peek () = if !at < n then text.[!at] else '\000' in
  let next () =
    let c = peek () in
    if !at >= n then wrong ();
    incr at;
    c
  in
  let expect c = if next () <> c then wrong () in
  let rec blank () =
    match peek () with
    | (' ' | '\t' | '\n' | '\r') when !at < n ->
        incr at;
        blank ()
    | _ -> ()
  in
  let word w v =
    String.iter expect w;
    v
  in
  let digits () =
    let start = !at in
    while peek () >= '0' && peek () <= '9' do
      incr at
    done;
    if !at = start then wrong ()
  in
  let number () =
    let start = !at in
    if peek () = '-' then incr at;
    if peek () = '0' then incr at else digits ();
    if peek () = '.' then (
      incr at;
      digits ());
    if peek () = 'e' || peek () = 'E' then (
      incr at;
      if peek () = '+' || peek () = '-' then incr at;
      digits ());
    Number (String.sub text start (!at - start))
  in
  let hex () =
    let digits = String.init 4 (fun _ -> next ()) in
    match int_of_string_opt ("0x" ^ digits) with
    | Some code when not (String.contains digits '_') -> code
    | Some _ | None -> wrong ()
  in
  let string () =
    expect '"';
    let b = Buffer.create 16 in
    let rec go () =
      match next () with
      | '"' -> ()
      | '\\' ->
          (match next () with
          | ('"' | '\\' | '/') as c -> Buffer.add_char b c
          | 'b' -> Buffer.add_char b '\b'
          | 'f' -> Buffer.add_char b '\012'
          | 'n' -> Buffer.add_char b '\n'
          | 'r' -> Buffer.add_char b '\r'
          | 't' -> Buffer.add_char b '\t'
          | 'u' -> Buffer.add_utf_8_uchar b (Uchar.of_int (hex ()))
          | _ -> wrong ());
          go ()
      | c when Char.code c < 0x20 -> wrong ()
      | c ->
          Buffer.add_char b c;
          go ()
    in
    go ();
    Buffer.contents b
  in
  let rec value () =
    blank ();
    let v =
      match peek () with
      | 'n' -> word "null" Null
      | 't' -> word "true" (Bool true)
      | 'f' -> word "false" (Bool false)
      | '"' -> String (string ())
      | '[' ->
          incr at;
          List (items ']' value)
      | '{' ->
          incr at;
          Object (items '}' field)
      | _ -> number ()
    in
    blank ();
    v
  and field () =
    blank ();
    let name = string () in
    blank ();
    expect ':';
    (name, value ())
  and items : 'a. char -> (unit -> 'a) -> 'a list =
   fun last item ->
    blank ();
    if peek () = last then (
      incr at;
      [])
    else
      let rec more items =
        let items = item () :: items in
        match next () with
        | ',' -> more items
        | c when c = last -> List.rev items
        | _ -> wrong ()
      in
      more []
  in
  if not (String.is_valid_utf_8 text) then Error 0
  else
    match value () with
    | v -> if !at = n then Ok v else Error !at
    | exception Wrong at -> Error at

(** [get path j] is what [path] leads to within objects. *)
let rec get path j =
  match (path, j) with
  | [], _ -> j
  | name :: path, Object fields -> (
      match List.assoc_opt name fields with
      | Some v -> get path v
      | None -> Alcotest.failf "no field %s" name)
  | name :: _, _ -> Alcotest.failf "%s is not in an object" name

let parse text =
  match read text with
  | Ok j -> j
  | Error at -> Alcotest.failf "not JSON from byte %d on:\n%s" at text
