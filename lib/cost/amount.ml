let signed show x =
  if Float.is_nan x then "—"
  else
    let size = Float.abs x in
    (if x < 0. then "−" else "") ^ if size = infinity then "∞" else show size

let raised = [| "⁰"; "¹"; "²"; "³"; "⁴"; "⁵"; "⁶"; "⁷"; "⁸"; "⁹" |]

let rec superscript n =
  if n < 0 then "⁻" ^ superscript (-n)
  else if n < 10 then raised.(n)
  else superscript (n / 10) ^ raised.(n mod 10)

let scientific x =
  let power = Float.floor (log10 x) in
  Printf.sprintf "%.1f·10%s"
    (x /. (10. ** power))
    (superscript (int_of_float power))

let plain x =
  if x = 0. then "0"
  else if x >= 1e6 || x < 0.001 then scientific x
  else if x >= 99.95 then Printf.sprintf "%.0f" x
  else if x >= 9.995 then Printf.sprintf "%.1f" x
  else if x >= 0.0995 then Printf.sprintf "%.2f" x
  else Printf.sprintf "%.2g" x

let number = signed plain
let round x = Float.is_integer x && x < 1e6

let digits x =
  if x >= 1e6 then scientific x
  else if x >= 9.95 || round x then Printf.sprintf "%.0f" x
  else if x >= 0.995 then Printf.sprintf "%.1f" x
  else Printf.sprintf "%.2f" x

(* The unit for a time of that size, and how many of it are a second. *)
let unit s =
  let s = Float.abs s in
  if s = 0. then ("s", 1.)
  else if s *. 1e6 < 995. then ("µs", 1e6)
  else if s *. 1e3 < 99.5 then ("ms", 1e3)
  else if s < 60. then ("s", 1.)
  else if s < 3600. then ("min", 1. /. 60.)
  else if s < 172_800. then ("h", 1. /. 3600.)
  else ("days", 1. /. 86_400.)

let bare_seconds s = signed digits (s *. snd (unit s))

let seconds s =
  let behind = if Float.is_finite s then "\u{a0}" ^ fst (unit s) else "" in
  bare_seconds s ^ behind

let range low high =
  let one_unit = Float.is_finite high && unit low = unit high in
  (if one_unit then bare_seconds low else seconds low) ^ " to " ^ seconds high

let error e = if e <> 0. && Float.abs e < 0.001 then "<0.001" else number e

let short x =
  if x = 0.5 then "½"
  else if x = 0.25 then "¼"
  else if x = 0.125 then "⅛"
  else if x >= 0.001 && x < 1e6 then Printf.sprintf "%g" x
  else plain x

let target = signed short

let change show d =
  let shown = show d in
  if d > 0. && not (String.starts_with ~prefix:"<" shown) then "+" ^ shown
  else shown

let percent share = signed digits (100. *. share) ^ "\u{a0}%"

let whole n =
  let digits = string_of_int (Int.abs n) in
  let length = String.length digits in
  let digit i c =
    let gap = i > 0 && (length - i) mod 3 = 0 in
    (if gap then "\u{202f}" else "") ^ String.make 1 c
  in
  let grouped = String.to_seq digits |> Seq.mapi digit |> List.of_seq in
  String.concat "" ((if n < 0 then "−" else "") :: grouped)

let count n noun = whole n ^ " " ^ noun ^ if n = 1 then "" else "s"
