type attributes = (string * string) list

type t =
  | Text of string
  | Element of { name : string; attributes : attributes; children : t list }
  | Void of { name : string; attributes : attributes }

let text s = Text s
let element name attributes children = Element { name; attributes; children }
let void name attributes = Void { name; attributes }

let allowed c =
  let code = Uchar.to_int c in
  (code >= 0x20 && not (code >= 0x7f && code < 0xa0))
  || code = 0x09 || code = 0x0a

let character b c =
  match Uchar.to_int c with
  | 0x26 -> Buffer.add_string b "&amp;"
  | 0x3c -> Buffer.add_string b "&lt;"
  | 0x3e -> Buffer.add_string b "&gt;"
  | 0x22 -> Buffer.add_string b "&quot;"
  | _ -> Buffer.add_utf_8_uchar b (if allowed c then c else Uchar.rep)

let rec escape b s at =
  if at < String.length s then begin
    let d = String.get_utf_8_uchar s at in
    (* The character of a decoding that failed is U+FFFD. *)
    character b (Uchar.utf_decode_uchar d);
    escape b s (at + Uchar.utf_decode_length d)
  end

let opening b name attributes =
  Printf.bprintf b "<%s" name;
  let attribute (key, value) =
    Printf.bprintf b " %s=\"" key;
    escape b value 0;
    Buffer.add_char b '"'
  in
  List.iter attribute attributes;
  Buffer.add_char b '>'

let rec write b = function
  | Text s -> escape b s 0
  | Void { name; attributes } -> opening b name attributes
  | Element { name; attributes; children } ->
      opening b name attributes;
      List.iter (write b) children;
      Printf.bprintf b "</%s>" name

let to_string m =
  let b = Buffer.create 4096 in
  write b m;
  Buffer.contents b

let document html = "<!DOCTYPE html>\n" ^ to_string html ^ "\n"
