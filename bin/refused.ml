open Cmdliner

let not_yet what = Error (what ^ " is not supported yet")

let refuse name given =
  Term.term_result' ~usage:false
    Term.(
      const (fun given -> if given then not_yet ("--" ^ name) else Ok ())
      $ given)

let with_value name =
  let given =
    Arg.(value & opt (some string) None & info [ name ] ~docs:Manpage.s_none)
  in
  refuse name Term.(const Option.is_some $ given)

let flag name =
  refuse name Arg.(value & flag & info [ name ] ~docs:Manpage.s_none)

let options =
  let both a b = Term.(const (fun () () -> ()) $ a $ b) in
  List.fold_left both (Term.const ())
    (List.map with_value [ "part" ] @ [ flag "resume" ])

(* Its options are taken too: they are not what is wrong with the line. *)
let command (name, doc, options) =
  let rest = Arg.(value & pos_all string [] & info [] ~docs:Manpage.s_none) in
  let also rest option =
    let given =
      Arg.(
        value & opt (some string) None & info [ option ] ~docs:Manpage.s_none)
    in
    Term.(const (fun rest _ -> rest) $ rest $ given)
  in
  let refuse _ =
    Status.Usage (Printf.sprintf "the command '%s' is not supported yet" name)
  in
  Cmd.v
    (Cmd.info name ~doc:(doc ^ " (not supported yet)") ~exits:Status.infos)
    Term.(const refuse $ List.fold_left also rest options)

let commands =
  List.map command
    [ ("merge", "join the parts of a picture", [ "o"; "output" ]) ]
