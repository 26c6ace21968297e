type 'a value = {
  words : unit -> string list;
  accepts : Located.t -> bool;
  read : Notes.t -> Located.t -> 'a option;
}

type 'a body = {
  arguments : string;
  read_body : Notes.t -> Form.t -> 'a option;
}

let read v = v.read
let words v = v.words ()
let accepts v = v.accepts
let body arguments read_body = { arguments; read_body }
let read_body b = b.read_body
let arguments b = b.arguments
let refuse = Notes.refuse

let is_atom (s : Located.t) =
  match s.node with Atom _ -> true | List _ -> false

let wrong_body notes (form : Form.t) ~arguments =
  refuse notes form.span
    (Printf.sprintf "expected %s, found %s"
       (Form.synopsis form.head arguments)
       (Form.found form))

(* [List.assoc] would compare polymorphically. *)
let rec case head = function
  | [] -> None
  | (head', body) :: _ when String.equal head head' -> Some body
  | _ :: cases -> case head cases

(* {1 Values} *)

let atom ~expected read_atom =
  let read notes (s : Located.t) =
    match s.node with
    | Atom a -> read_atom notes s.span a
    | List _ ->
        refuse notes s.span
          (Printf.sprintf "expected %s, not %s" (expected ()) (Form.quote s))
  in
  { words = (fun () -> []); accepts = is_atom; read }

let word cases =
  let words = List.map fst cases in
  let expected () = Quote.list (List.map Quote.word words) in
  let read_atom notes span a =
    match case a cases with
    | Some _ as found -> found
    | None ->
        refuse notes span
          ?hint:(Spelling.hint a ~among:words)
          (Printf.sprintf "expected %s, not %s" (expected ()) (Quote.word a))
  in
  atom ~expected read_atom

let expected () = "a name"
let name = atom ~expected (fun _ span a -> Some (a, span))

let reference kind =
  atom ~expected (fun notes span a -> Some (Notes.mention notes kind a span))

let choice what ?atom cases =
  let heads = List.map fst cases in
  let accepts (s : Located.t) =
    match Located.head s with
    | Some head -> Option.is_some (case head cases)
    | None -> is_atom s && Option.is_some atom
  in
  let mistaken notes (s : Located.t) =
    let hint =
      match s.node with
      | Atom a when List.mem_assoc a cases ->
          Some (Printf.sprintf "did you mean %s?" (Form.title a))
      | Atom _ | List _ -> Form.unexpected "" ~among:heads
    in
    refuse notes s.span ?hint
      (Printf.sprintf "expected a %s, not %s" what (Form.quote s))
  in
  let read notes (s : Located.t) =
    match (s.node, atom) with
    | Atom _, Some atom -> atom.read notes s
    | Atom _, None | List ([] | { node = List _; _ } :: _), _ ->
        mistaken notes s
    | List ({ node = Atom head; _ } :: body), _ -> (
        match case head cases with
        | Some body' -> body'.read_body notes { head; span = s.span; body }
        | None ->
            refuse notes s.span
              ?hint:(Form.unexpected head ~among:heads)
              (Printf.sprintf "unknown %s %s" what (Quote.word head)))
  in
  { words = (fun () -> heads); accepts; read }

let tuple b =
  let read notes (s : Located.t) =
    match s.node with
    | List body -> b.read_body notes { Form.head = ""; span = s.span; body }
    | Atom a ->
        refuse notes s.span
          (Printf.sprintf "expected %s, not %s"
             (Form.synopsis "" b.arguments)
             (Quote.word a))
  in
  let accepts (s : Located.t) =
    match (s.node, Located.head s) with
    | List _, Some head -> Number.is_meant head
    | List [], None -> true
    | List (_ :: _), None | Atom _, _ -> false
  in
  let words () = [ Form.synopsis "" b.arguments ] in
  { words; accepts; read }

let fix f =
  let rec self =
    lazy
      (f
         {
           words = (fun () -> (Lazy.force self).words ());
           accepts = (fun s -> (Lazy.force self).accepts s);
           read = (fun notes s -> (Lazy.force self).read notes s);
         })
  in
  Lazy.force self

let map_value f v =
  { v with read = (fun notes s -> Option.map f (v.read notes s)) }

(* {1 Bodies} *)

let map f b =
  {
    b with
    read_body = (fun notes form -> Option.map f (b.read_body notes form));
  }

let check f b =
  let read_body notes (form : Form.t) =
    match Option.map f (b.read_body notes form) with
    | None -> None
    | Some (Ok y) -> Some y
    | Some (Error why) ->
        refuse notes form.span
          (Printf.sprintf "%s: %s" (Form.title form.head) why)
  in
  { b with read_body }

let one arguments v =
  let read_body notes (form : Form.t) =
    match form.body with
    | [ s ] -> v.read notes s
    | [] | _ :: _ :: _ -> wrong_body notes form ~arguments
  in
  { arguments; read_body }

let all options =
  if List.for_all Option.is_some options then
    Some (List.filter_map Fun.id options)
  else None

let several arguments v =
  let names = String.split_on_char ' ' arguments in
  let called (form : Form.t) name () =
    match names with
    | [ _ ] -> Form.title form.head
    | [] | _ :: _ :: _ -> name ^ " of " ^ Form.title form.head
  in
  let read_body notes (form : Form.t) =
    let read name s = (v (called form name)).read notes s in
    if List.compare_lengths names form.body <> 0 then
      wrong_body notes form ~arguments
    else all (List.map2 read names form.body)
  in
  { arguments; read_body } |> map Array.of_list

let triple b =
  let v = tuple b in
  let list = Form.synopsis "" b.arguments in
  let arguments = String.concat " " [ list; list; list ] in
  let read_body notes (form : Form.t) =
    match form.body with
    | [ a; b; c ] -> (
        match (v.read notes a, v.read notes b, v.read notes c) with
        | Some a, Some b, Some c -> Some (a, b, c)
        | None, _, _ | _, None, _ | _, _, None -> None)
    | [] | [ _ ] | [ _; _ ] | _ :: _ :: _ :: _ :: _ ->
        wrong_body notes form ~arguments
  in
  { arguments; read_body }

let flag =
  let read_body notes (form : Form.t) =
    if List.is_empty form.body then Some ()
    else wrong_body notes form ~arguments:""
  in
  { arguments = ""; read_body }

let named b =
  let arguments = "NAME " ^ b.arguments in
  let read_body notes (form : Form.t) =
    match form.body with
    | { node = Atom name; span } :: body ->
        let head = form.head ^ " " ^ Quote.brief name in
        Some (name, span, b.read_body notes { form with head; body })
    | [] | { node = List _; _ } :: _ ->
        refuse notes form.span
          (Printf.sprintf "expected a name: %s"
             (Form.synopsis form.head arguments))
  in
  { arguments; read_body }

let referring kind b =
  let b' = named b in
  let read_body notes form =
    match b'.read_body notes form with
    | None -> None
    | Some (name, span, value) ->
        let name = Notes.mention notes kind name span in
        Option.map (fun value -> (name, value)) value
  in
  { b' with read_body }

let placed b =
  let read_body notes (form : Form.t) =
    let at place_it = place_it (Notes.place notes form.span) in
    Option.map at (b.read_body notes form)
  in
  { b with read_body }
