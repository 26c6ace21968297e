open Candor_scene

(* [Place] is what only the scene remembers, to be found again in the text. *)
type spot = Nowhere | Span of Span.t | Place of Place.t

type note = {
  source : Source.t;
  spot : spot;
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
  mutable pictures : (Texels.t, string) result Names.t;
  mutable meshes : (Faces.t, string) result Names.t;
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
      pictures = Names.empty;
      meshes = Names.empty;
    }
  in
  { book; source = Source.of_string ~name:"" "" }

let within n source =
  n.book.sources <- source :: n.book.sources;
  { n with source }

let place_in source (span : Span.t) =
  { Place.file = Source.name source; line = span.line; column = span.column }

let place n span = place_in n.source span
let beside n path = Source.beside n.source path
let is_full book = book.length >= longest

let add book note =
  if is_full book then book.unnoted <- book.unnoted + 1
  else (
    book.notes <- note :: book.notes;
    book.length <- book.length + 1)

let error n span ?hint message =
  add n.book { source = n.source; spot = Span span; message; hint }

let refuse n span ?hint message =
  error n span ?hint message;
  None

let error_at n place ?hint message =
  add n.book { source = n.source; spot = Place place; message; hint }

let give_up n = n.book.incomplete <- true
let is_clean n = n.book.length = 0
let incomplete n = n.book.incomplete

let fault n (f : Fault.t) =
  let trusted (note : note) =
    note.source != n.source
    ||
    match note.spot with
    | Span span -> span.offset < f.distrust
    | Nowhere | Place _ -> true
  in
  give_up n;
  n.book.notes <- List.filter trusted n.book.notes;
  n.book.length <- List.length n.book.notes;
  let spot = Option.fold f.span ~none:Nowhere ~some:(fun s -> Span s) in
  add n.book { source = n.source; spot; message = f.message; hint = f.hint }

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

(* What [known] has for [key], else what is loaded, which is kept. *)
let once known key load ~keep =
  match Names.find_opt key known with
  | Some found -> found
  | None ->
      let loaded = load () in
      keep (Names.add key loaded known);
      loaded

let picture { book; _ } key load =
  once book.pictures key load ~keep:(fun all -> book.pictures <- all)

let mesh { book; _ } key load =
  once book.meshes key load ~keep:(fun all -> book.meshes <- all)

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
      add n.book { source = m.where; spot = Span m.first; message; hint }
  in
  Names.iter check (mentions n.book kind)

(* The notes with places as spans of their sources, each read once for that. *)
let retraced book =
  let sources =
    Names.of_list (List.map (fun s -> (Source.name s, s)) book.sources)
  in
  let gather places note =
    match note.spot with
    | Place p -> Names.add_to_list p.file p places
    | Span _ | Nowhere -> places
  in
  let retrace file places =
    let spans source = (source, Retrace.spans source places) in
    Option.map spans (Names.find_opt file sources)
  in
  let spans =
    List.fold_left gather Names.empty book.notes |> Names.filter_map retrace
  in
  let span (p : Place.t) =
    let found (source, span) = Option.map (fun s -> (source, s)) (span p) in
    Option.bind (Names.find_opt p.file spans) found
  in
  let replace note =
    match note.spot with
    | Span _ | Nowhere -> note
    | Place p ->
        let found (source, s) = { note with source; spot = Span s } in
        Option.fold (span p) ~none:note ~some:found
  in
  List.map replace book.notes

(* Places of notes in order: the rank of the file, then the offset in it. *)
let keys book =
  let rank i source = (Source.name source, -i) in
  let ranks = Names.of_seq (List.to_seq (List.mapi rank book.sources)) in
  fun (note : note) ->
    let offset =
      match note.spot with
      | Span s -> s.offset + s.mark
      | Place _ | Nowhere -> -1
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
  let place, excerpt =
    match note.spot with
    | Span s -> (place_in note.source s, Excerpt.of_source note.source s)
    | Place p -> (p, None)
    | Nowhere -> ({ file = Source.name note.source; line = 0; column = 0 }, None)
  in
  { place; message = note.message; hint = note.hint; excerpt }

let report n : Error.report =
  let key = keys n.book in
  let notes =
    List.sort_uniq
      (fun a b -> compare_keys (key a) (key b))
      (List.rev (retraced n.book))
  in
  let shown = List.filteri (fun i _ -> i < Error.most) notes in
  {
    errors = List.map to_error shown;
    more = List.length notes - List.length shown + n.book.unnoted;
  }
