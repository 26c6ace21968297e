(* What files a scene is made of as it is read: how long to wait for pipes, and
   how many inclusions are left. Files that include others twice in turn would
   otherwise grow without end. *)
type reading = { patience : float option; mutable left : int }

let most_inclusions = 10_000

(* [chain] is the files that are being read, innermost first. *)
let rec add_all reading notes chain source ~bare t =
  let notes = Notes.within notes source in
  (* local mutation: the fold of a callback *)
  let result = ref t in
  let form = Top_level.form ~include_:(add_file reading (source :: chain)) in
  let add located =
    Option.iter
      (fun add -> result := add !result)
      (Decode.read form notes located)
  in
  let where =
    match Forms.iter source ~bare add with
    | Ok span -> span
    | Error fault ->
        Notes.fault notes fault;
        Span.start
  in
  Source.close source;
  (notes, where, !result)

and add_file reading chain notes span path t =
  let refuse message =
    Notes.error notes span message;
    Notes.give_up notes;
    t
  in
  let from =
    match chain with [] -> path | source :: _ -> Source.beside source path
  in
  match Source.open_file ?patience:reading.patience from with
  | Error why -> refuse (Printf.sprintf "%s: %s" (Quote.word from) why)
  | Ok source when List.exists (Source.same source) chain ->
      Source.close source;
      let names = List.rev_map Source.name (source :: chain) in
      refuse ("a file includes itself: " ^ Quote.chain names)
  | Ok source when reading.left <= 0 ->
      Source.close source;
      refuse (Printf.sprintf "more than %d inclusions in all" most_inclusions)
  | Ok source ->
      reading.left <- reading.left - 1;
      let _, _, t = add_all reading notes chain source ~bare:true t in
      t

let finish notes (main, span, t) =
  match Top_level.finish main span t with
  | Some scene -> Ok scene
  | None -> Error (Notes.report notes)

let of_source ?patience notes source =
  let reading = { patience; left = most_inclusions } in
  add_all reading notes [] source ~bare:false Top_level.empty |> finish notes

let of_string ~name text =
  of_source (Notes.make ()) (Source.of_string ~name text)

let read ?patience path =
  let notes = Notes.make () in
  match Source.open_file ?patience path with
  | Ok source -> of_source ?patience notes source
  | Error why ->
      let source = Source.of_string ~name:path "" in
      Notes.fault (Notes.within notes source) (Fault.unreadable why);
      Error (Notes.report notes)
