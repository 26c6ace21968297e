let longest = 40
let printable = function '\000' .. '\031' | '\127' .. '\255' -> '?' | c -> c
let plain s = String.map printable s

let brief s =
  if String.is_valid_utf_8 s && String.length s <= longest then
    String.map (fun c -> if Char.code c >= 128 then c else printable c) s
  else if String.length s <= longest then plain s
  else plain (String.sub s 0 (longest - 3)) ^ "..."

let word s = "`" ^ brief s ^ "`"

let list words =
  match List.rev words with
  | [] -> ""
  | [ only ] -> only
  | last :: rest -> String.concat ", " (List.rev rest) ^ " or " ^ last

let count n thing = Printf.sprintf "%d %s%s" n thing (if n = 1 then "" else "s")

let chain names =
  let shown = List.filteri (fun i _ -> i < 8) names in
  let rest = List.length names - List.length shown in
  String.concat " -> " (List.map word shown)
  ^ if rest = 0 then "" else Printf.sprintf " -> and %d more" rest
