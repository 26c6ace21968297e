let units = [ ("s", 1.); ("m", 60.); ("h", 3600.) ]

(* The number and the unit that [text] ends in. *)
let parts text =
  let with_unit (suffix, seconds) =
    if String.ends_with ~suffix text then
      let digits = String.length text - String.length suffix in
      Some (String.sub text 0 digits, seconds)
    else None
  in
  Option.value (List.find_map with_unit units) ~default:(text, 1.)

let is_decimal c = (c >= '0' && c <= '9') || c = '.'

let parse text =
  let number, unit = parts text in
  match float_of_string_opt number with
  | Some n when String.for_all is_decimal number && n > 0. -> Ok (n *. unit)
  | Some _ | None ->
      Error
        (Printf.sprintf "'%s': expected a time above 0, such as 20s or 1.5m"
           text)

let print ppf seconds = Format.fprintf ppf "%gs" seconds
let conv = Cmdliner.Arg.Conv.make ~docv:"T" ~parser:parse ~pp:print ()
