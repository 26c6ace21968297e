type t = { text : string; indent : int; width : int }

let widest = 76
let dots = "..."

(* Bytes that continue a character of UTF-8. *)
let continues c = Char.code c land 0xC0 = 0x80

let printable (d : Uchar.utf_decode) u =
  Uchar.utf_decode_is_valid d && u >= 0x20 && not (0x7F <= u && u < 0xA0)

(* Every character as one column, whatever is not one shown as [?]. *)
let columns s =
  let show shown i d =
    let u = Uchar.to_int (Uchar.utf_decode_uchar d) in
    if u = Char.code '\t' then " " :: shown
    else if printable d u then
      String.sub s i (Uchar.utf_decode_length d) :: shown
    else "?" :: shown
  in
  let rec go shown i =
    if i >= String.length s then List.rev shown
    else
      let d = String.get_utf_8_uchar s i in
      go (show shown i d) (i + Uchar.utf_decode_length d)
  in
  go [] 0

(* [first] and [last] bound the part of the line to show, moved inwards to whole
   characters. *)
let window line ~mark =
  let length = String.length line in
  if length <= widest then (0, length)
  else
    let room = widest - (2 * String.length dots) in
    let first = Int.max 0 (Int.min (mark - (room / 2)) (length - room)) in
    let last = Int.min length (first + room) in
    let rec whole step i =
      if 0 < i && i < length && continues line.[i] then whole step (i + step)
      else i
    in
    (whole 1 first, whole (-1) last)

let of_line line ~mark ~width ~cut =
  let first, last = window line ~mark in
  let piece i j = columns (String.sub line i (Int.max 0 (j - i))) in
  let before = piece first mark
  and meant = piece mark (Int.min last (mark + width))
  and after = piece (Int.min last (mark + width)) last in
  let left = if first > 0 || cut then dots else "" in
  let right = if last < String.length line then dots else "" in
  {
    text = left ^ String.concat "" (before @ meant @ after) ^ right;
    indent = String.length left + List.length before;
    width = Int.max 1 (List.length meant);
  }

let end_of_line text =
  match String.index_opt text '\n' with
  | Some n when n > 0 && Char.equal text.[n - 1] '\r' -> n - 1
  | Some n -> n
  | None -> String.length text

let of_source source (span : Span.t) =
  let meant = span.offset + span.mark in
  let line_start = span.offset - span.column + 1 in
  let first = Int.max line_start (meant - (4 * widest)) in
  let before = Source.slice source ~first ~last:meant in
  let rest = Source.slice source ~first:meant ~last:(meant + (4 * widest)) in
  let line = before ^ String.sub rest 0 (end_of_line rest) in
  if String.equal line "" then None
  else
    Some
      (of_line line ~mark:(String.length before) ~width:span.width
         ~cut:(first > line_start))
