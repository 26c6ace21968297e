(* Pages whose code blocks are what was measured: {@text NAME[ … ]}. *)

let opening line =
  match Scanf.sscanf line "{@text %s@[%!" Fun.id with
  | name -> Some name
  | exception (Scanf.Scan_failure _ | End_of_file) -> None

let closing = "]}"

(** [block (name, text)] is the block of that name, as lines. *)
let block (name, text) =
  (Printf.sprintf "{@text %s[" name :: String.split_on_char '\n' text)
  @ [ closing ]

let rec until_closed = function
  | line :: rest when line = closing -> ([], rest)
  | line :: rest ->
      let inside, rest = until_closed rest in
      (line :: inside, rest)
  | [] -> ([], [])

(** [blocks lines] is each block of a page by its name. *)
let rec blocks = function
  | line :: rest -> (
      match opening line with
      | Some name ->
          let inside, rest = until_closed rest in
          (name, String.concat "\n" inside) :: blocks rest
      | None -> blocks rest)
  | [] -> []

(** [fill found page] is the lines of [page], its blocks replaced by those of
    the same name among [found]. *)
let rec fill found = function
  | line :: rest -> (
      match
        Option.bind (opening line) (fun n ->
            List.find_opt (fun (m, _) -> m = n) found)
      with
      | Some found_here ->
          let _, rest = until_closed rest in
          block found_here @ fill found rest
      | None -> line :: fill found rest)
  | [] -> []
