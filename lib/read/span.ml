type t = { line : int; column : int; offset : int; mark : int; width : int }

let start = { line = 1; column = 1; offset = 0; mark = 0; width = 1 }

let after s c =
  let offset = s.offset + 1 in
  if Char.equal c '\n' then { s with line = s.line + 1; column = 1; offset }
  else { s with column = s.column + 1; offset }

let of_position (p : Parsexp.Positions.pos) =
  { start with line = p.line; column = p.col + 1; offset = p.offset }

let to_position s : Parsexp.Positions.pos =
  { line = s.line; col = s.column - 1; offset = s.offset }

let to_string s = Printf.sprintf "%d:%d" s.line s.column
