type number =
  | Int8
  | Uint8
  | Int16
  | Uint16
  | Int32
  | Uint32
  | Float32
  | Float64

type property = Scalar of string * number | List of string * number * number
type element = { name : string; count : int; properties : property array }
type form = Ascii | Binary of { big_endian : bool }
type t = { form : form; elements : element list }

let bytes = function
  | Int8 | Uint8 -> 1
  | Int16 | Uint16 -> 2
  | Int32 | Uint32 | Float32 -> 4
  | Float64 -> 8

let is_whole = function
  | Int8 | Uint8 | Int16 | Uint16 | Int32 | Uint32 -> true
  | Float32 | Float64 -> false

let refuse = Mesh_text.refuse

let number text word =
  match word with
  | "char" | "int8" -> Int8
  | "uchar" | "uint8" -> Uint8
  | "short" | "int16" -> Int16
  | "ushort" | "uint16" -> Uint16
  | "int" | "int32" -> Int32
  | "uint" | "uint32" -> Uint32
  | "float" | "float32" -> Float32
  | "double" | "float64" -> Float64
  | _ -> refuse text (Quote.word word ^ " is not a type of PLY")

let property text =
  match Mesh_text.need text "a type" with
  | "list" ->
      let length = number text (Mesh_text.need text "a type") in
      let item = number text (Mesh_text.need text "a type") in
      if is_whole length then List (Mesh_text.need text "a name", length, item)
      else refuse text "the length of a list is a whole number"
  | word ->
      let number = number text word in
      Scalar (Mesh_text.need text "a name", number)

let element text =
  let name = Mesh_text.need text "a name" in
  let word = Mesh_text.need text "a number" in
  match int_of_string_opt word with
  | Some count when count >= 0 -> { name; count; properties = [||] }
  | Some _ | None ->
      refuse text
        (Printf.sprintf "%s is not a number of rows" (Quote.word word))

let form text =
  match Mesh_text.need text "a format" with
  | "ascii" -> Ascii
  | "binary_little_endian" -> Binary { big_endian = false }
  | "binary_big_endian" -> Binary { big_endian = true }
  | word ->
      refuse text
        ("expected ascii, binary_little_endian or binary_big_endian, not "
       ^ Quote.word word)

let magic text =
  if not (String.equal (Mesh_text.word text) "ply") then
    refuse text "a PLY file begins with `ply`";
  Mesh_text.next_line text

let expect_form text =
  match Mesh_text.word text with
  | "format" -> form text
  | _ -> refuse text "expected `format` in the second line"

let closed element properties =
  { element with properties = Array.of_list (List.rev properties) }

(* Both lists hold the latest first. *)
let rec elements text found current properties =
  let next = elements text in
  let all () =
    Option.fold current ~none:found ~some:(fun e ->
        closed e properties :: found)
  in
  Mesh_text.next_line text;
  if Mesh_text.is_over text then
    refuse text "the file ends before its `end_header`";
  match (Mesh_text.word text, current) with
  | "element", _ ->
      let e = element text in
      next (all ()) (Some e) []
  | "property", Some _ -> next found current (property text :: properties)
  | "property", None -> refuse text "a property of what? No element is above"
  | ("" | "comment" | "obj_info"), _ -> next found current properties
  | "end_header", _ ->
      Mesh_text.next_line text;
      List.rev (all ())
  | word, _ ->
      refuse text
        ("expected element, property, comment or end_header, not "
       ^ Quote.word word)

let read text =
  magic text;
  let form = expect_form text in
  { form; elements = elements text [] None [] }
