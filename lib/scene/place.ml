type t = { file : string; line : int; column : int } [@@deriving show, eq, ord]

let unknown = { file = "default"; line = 0; column = 0 }
let to_string p = Printf.sprintf "%s:%d:%d" p.file p.line p.column
