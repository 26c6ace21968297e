(* What the sources of the kernels must not say. *)

open Candor_oracle

let lib = Filename.(concat (dirname Sys.executable_name) "../../lib")
let orders = [ "min"; "max"; "compare" ]

(* Stdlib's order of anything: of floats it is slow, and with nan the result of
   min and max depends on which comes first. Not what the file itself calls so. *)
let is_order bound = function
  | [ name ] -> List.mem name orders && not (List.mem name bound)
  | [ "Stdlib"; name ] -> List.mem name orders
  | _ -> false

let uses structure =
  (* Local mutation: what the walk has found. *)
  let used = ref [] and bound = ref [] in
  let open Parsetree in
  let iterator =
    let default = Ast_iterator.default_iterator in
    let pat it p =
      (match p.ppat_desc with
      | Ppat_var { txt; _ } -> bound := txt :: !bound
      | _ -> ());
      default.pat it p
    and expr it e =
      (match e.pexp_desc with
      | Pexp_ident { txt; loc } -> used := (Longident.flatten txt, loc) :: !used
      | _ -> ());
      default.expr it e
    in
    { default with pat; expr }
  in
  iterator.structure iterator structure;
  List.filter (fun (name, _) -> is_order !bound name) !used

let uses_in file =
  In_channel.with_open_bin file (fun channel ->
      let buffer = Lexing.from_channel channel in
      Lexing.set_filename buffer file;
      uses (Parse.implementation buffer))

(* What dune makes of a source beside it has one more dot in its name. *)
let is_source name =
  String.ends_with ~suffix:".ml" name
  && not (String.contains (Filename.remove_extension name) '.')

let sources folder =
  let folder = Filename.concat lib folder in
  Array.to_list (Sys.readdir folder)
  |> List.filter is_source
  |> List.map (Filename.concat folder)

let ordered_by_stdlib () =
  let files = List.concat_map sources [ "number"; "space"; "surface" ] in
  Alcotest.(check bool) "there are sources" true (List.length files > 30);
  let check file =
    match uses_in file with
    | [] -> ()
    | (name, loc) :: _ ->
        Alcotest.failf "%a: %s" Location.print_loc loc (String.concat "." name)
  in
  List.iter check files

let seen () =
  let found text =
    List.map fst (uses (Parse.implementation (Lexing.from_string text)))
  in
  let check text expected =
    Alcotest.(check (list (list string))) text expected (found text)
  in
  check "let f a b = if a < b then a else Float.min a b" [];
  check "let f a b = min a b" [ [ "min" ] ];
  check "let f = List.fold_left max 0." [ [ "max" ] ];
  check "let f a b = Stdlib.compare a b" [ [ "Stdlib"; "compare" ] ];
  check "let f ~min a = min + a" [];
  check "let compare a b = Float.compare a b let equal a b = compare a b = 0" []

let suite =
  ( "sources",
    [
      Law.example "G27: kernels never order by Stdlib's min, max and compare"
        ordered_by_stdlib;
      Law.example "G27: and would be found to" seen;
    ] )
