open Decode

(* [takes] tells what belongs to these fields, [suggest] names it. Unless
   [sound], what seems to be missing may only be misspelt. *)
type 'a fields = {
  suggest : unit -> string list;
  takes : Located.t -> bool;
  take : Notes.t -> Form.t -> sound:bool -> 'a option;
}

let ( let+ ) f g =
  {
    f with
    take = (fun notes form ~sound -> Option.map g (f.take notes form ~sound));
  }

let ( and+ ) f g =
  let take notes form ~sound =
    let a = f.take notes form ~sound in
    let b = g.take notes form ~sound in
    match (a, b) with
    | Some a, Some b -> Some (a, b)
    | None, _ | _, None -> None
  in
  {
    suggest = (fun () -> f.suggest () @ g.suggest ());
    takes = (fun s -> f.takes s || g.takes s);
    take;
  }

let nothing =
  {
    suggest = (fun () -> []);
    takes = (fun _ -> false);
    take = (fun _ _ ~sound:_ -> Some ());
  }

let is_headed head s =
  match Located.head s with Some h -> String.equal h head | None -> false

let forms head (form : Form.t) =
  List.filter_map Form.of_located (List.filter (is_headed head) form.body)

let refuse_again notes ~outer ~first (form : Form.t) =
  Notes.refuse notes form.span
    (Printf.sprintf "%s is given twice in %s" (Form.title form.head)
       (Form.title outer))
    ~hint:("the first is at " ^ Span.to_string first)

let optional head b =
  let take notes (form : Form.t) ~sound:_ =
    match forms head form with
    | [] -> Some None
    | [ only ] -> Option.map Option.some (read_body b notes only)
    | { span = first; _ } :: again ->
        let refuse _ = refuse_again notes ~outer:form.head ~first in
        List.fold_left refuse None again
  in
  { suggest = (fun () -> [ head ]); takes = is_headed head; take }

let field head b =
  let f = optional head b in
  let take notes (form : Form.t) ~sound =
    match f.take notes form ~sound with
    | None -> None
    | Some (Some _ as found) -> found
    | Some None when not sound -> None
    | Some None ->
        Notes.refuse notes form.span
          (Printf.sprintf "%s needs %s" (Form.title form.head)
             (Form.synopsis head (arguments b)))
  in
  { f with take }

let default head b x =
  let+ found = optional head b in
  Option.value found ~default:x

let present head =
  let+ found = optional head flag in
  Option.is_some found

let items v =
  let take notes (form : Form.t) ~sound:_ =
    all (List.map (read v notes) (List.filter (accepts v) form.body))
  in
  { suggest = (fun () -> words v); takes = accepts v; take }

let item what v =
  let list = items v in
  let take notes (form : Form.t) ~sound =
    let refuse found =
      Notes.refuse notes form.span
        (Printf.sprintf "%s needs one %s, not %s" (Form.title form.head) what
           found)
        ?hint:(Form.unexpected "" ~among:(words v))
    in
    match list.take notes form ~sound with
    | None -> None
    | Some [ only ] -> Some only
    | Some [] -> if sound then refuse "none" else None
    | Some (_ :: _ :: _ as several) ->
        refuse (string_of_int (List.length several))
  in
  { list with take }

(* Of what is out of place altogether the first says enough: the rest of a form
   that was not closed follows it. *)
let refuse_strays notes (outer : Form.t) ~suggest strays =
  let outer = Form.title outer.head in
  let error (s : Located.t) = Notes.error notes s.span in
  let add out_of_place (s : Located.t) =
    match Located.head s with
    | Some head when not (List.mem head Words.top_level) ->
        error s
          ?hint:(Form.unexpected head ~among:(suggest ()))
          (Printf.sprintf "unknown field %s in %s" (Quote.word head) outer);
        out_of_place
    | (Some _ | None) when out_of_place -> true
    | Some head ->
        error s ~hint:"it belongs to the top level: is a `)` missing before it?"
          (Printf.sprintf "%s has no place in %s" (Form.title head) outer);
        true
    | None ->
        error s
          ?hint:(Form.unexpected "" ~among:(suggest ()))
          (Printf.sprintf "%s has no place in %s" (Form.quote s) outer);
        true
  in
  let (_ : bool) = List.fold_left add false strays in
  ()

let fields f =
  let read_body notes (form : Form.t) =
    let sound = List.for_all f.takes form.body in
    if not sound then
      List.filter (fun s -> not (f.takes s)) form.body
      |> refuse_strays notes form ~suggest:f.suggest;
    let value = f.take notes form ~sound in
    if sound then value else None
  in
  body "..." read_body
