open Candor_scene

type note = {
  source : Source.t;
  span : Span.t option;
  message : string;
  hint : string option;
}

type kind = Material | Definition

module Names = Map.Make (String)

type mention = {
  name : string;
  where : Source.t;
  first : Span.t;
  mutable times : int;
}

type book = {
  mutable notes : note list;  (** latest first *)
  mutable length : int;
  mutable unnoted : int;
  mutable sources : Source.t list;  (** latest first *)
  mutable incomplete : bool;
  mutable materials : mention Names.t;
  mutable definitions : mention Names.t;
}

type t = { book : book; source : Source.t }

let longest = 1000

let make () =
  let book =
    {
      notes = [];
      length = 0;
      unnoted = 0;
      sources = [];
      incomplete = false;
      materials = Names.empty;
      definitions = Names.empty;
    }
  in
  { book; source = Source.of_string ~name:"" "" }

let within n source =
  n.book.sources <- source :: n.book.sources;
  { n with source }

let place_in source (span : Span.t) =
  { Place.file = Source.name source; line = span.line; column = span.column }

let place n span = place_in n.source span
let is_full book = book.length >= longest

let add book note =
  if is_full book then book.unnoted <- book.unnoted + 1
  else (
    book.notes <- note :: book.notes;
    book.length <- book.length + 1)

let error n span ?hint message =
  add n.book { source = n.source; span = Some span; message; hint }

let refuse n span ?hint message =
  error n span ?hint message;
  None

let give_up n = n.book.incomplete <- true
let is_clean n = n.book.length = 0
let incomplete n = n.book.incomplete

let fault n (f : Fault.t) =
  let trusted (note : note) =
    note.source != n.source
    ||
    match note.span with
    | Some span -> span.offset < f.distrust
    | None -> true
  in
  give_up n;
  n.book.notes <- List.filter trusted n.book.notes;
  n.book.length <- List.length n.book.notes;
  add n.book
    { source = n.source; span = f.span; message = f.message; hint = f.hint }

let mentions book = function
  | Material -> book.materials
  | Definition -> book.definitions

let mention n kind name first =
  let mentions = mentions n.book kind in
  match Names.find_opt name mentions with
  | Some m ->
      m.times <- m.times + 1;
      m.name
  | None ->
      let m = { name; where = n.source; first; times = 1 } in
      let mentions = Names.add name m mentions in
      (match kind with
      | Material -> n.book.materials <- mentions
      | Definition -> n.book.definitions <- mentions);
      name

let noun = function Material -> "material" | Definition -> "definition"

let check_mentions n kind ~is_known ~known =
  let check name m =
    if not (is_known name) then
      let times =
        if m.times = 1 then "" else Printf.sprintf " (used %d times)" m.times
      in
      let hint =
        if is_full n.book then None else Spelling.hint name ~among:known
      in
      let message =
        Printf.sprintf "no %s is called %s%s" (noun kind) (Quote.word name)
          times
      in
      add n.book { source = m.where; span = Some m.first; message; hint }
  in
  Names.iter check (mentions n.book kind)

(* Places of notes in order: the rank of the file, then the offset in it. *)
let keys book =
  let rank i source = (Source.name source, -i) in
  let ranks = Names.of_seq (List.to_seq (List.mapi rank book.sources)) in
  fun (note : note) ->
    let offset =
      match note.span with Some s -> s.offset + s.mark | None -> -1
    in
    let rank = Names.find_opt (Source.name note.source) ranks in
    (Option.value rank ~default:0, offset, note.message)

let compare_keys (rank, offset, message) (rank', offset', message') =
  match Int.compare rank rank' with
  | 0 -> (
      match Int.compare offset offset' with
      | 0 -> String.compare message message'
      | order -> order)
  | order -> order

let to_error (note : note) : Error.t =
  let nowhere =
    { Place.file = Source.name note.source; line = 0; column = 0 }
  in
  {
    place = Option.fold note.span ~none:nowhere ~some:(place_in note.source);
    message = note.message;
    hint = note.hint;
    excerpt = Option.bind note.span (Excerpt.of_source note.source);
  }

let report n : Error.report =
  let key = keys n.book in
  let notes =
    List.sort_uniq
      (fun a b -> compare_keys (key a) (key b))
      (List.rev n.book.notes)
  in
  let shown = List.filteri (fun i _ -> i < Error.most) notes in
  {
    errors = List.map to_error shown;
    more = List.length notes - List.length shown + n.book.unnoted;
  }
