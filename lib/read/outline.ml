type mode =
  | Code
  | Word
  | Hash  (** after a [#] that may begin a comment, or a word *)
  | Line  (** in a comment up to the end of the line *)
  | Text of { escaped : bool }
  | Block of { depth : int; last : char }
  | Block_text of { depth : int; escaped : bool }
      (** strings hide the ends of comments in comments too *)

type t = {
  here : Span.t;
  mode : mode;
  since : Span.t;  (** where the string or comment began *)
  opened : Span.t list;  (** parentheses, innermost first *)
  doubt : (Span.t * int) option;
  indented : bool;  (** only white space on this line so far *)
  is_blank : bool;
  bare : bool;
}

let start ~bare here =
  {
    here;
    mode = Code;
    since = here;
    opened = [];
    doubt = None;
    indented = true;
    is_blank = true;
    bare;
  }

let here o = o.here
let is_blank o = o.is_blank

(* A line that begins at or before the column of an open parenthesis other than
   the one around everything. *)
let doubt o =
  match (o.doubt, o.opened) with
  | None, opened :: outer
    when o.indented
         && o.here.column <= opened.column
         && (o.bare || not (List.is_empty outer)) ->
      Some (opened, o.here.line)
  | doubt, _ -> doubt

let code o c =
  match c with
  | ' ' | '\t' | '\r' | '\012' -> { o with mode = Code }
  | '\n' -> { o with mode = Code; indented = true }
  | ';' -> { o with mode = Line }
  | '#' -> { o with mode = Hash; since = o.here }
  | '"' ->
      let mode = Text { escaped = false } in
      { o with mode; since = o.here; is_blank = false }
  | '(' ->
      let opened = o.here :: o.opened and doubt = doubt o in
      { o with mode = Code; opened; doubt; indented = false; is_blank = false }
  | ')' ->
      let opened = match o.opened with [] -> [] | _ :: outer -> outer in
      { o with mode = Code; opened; indented = false; is_blank = false }
  | _ -> { o with mode = Word; indented = false; is_blank = false }

let step o c =
  match (o.mode, c) with
  | Code, _ -> code o c
  | Hash, '|' -> { o with mode = Block { depth = 1; last = ' ' } }
  | Hash, ';' -> { o with mode = Code; is_blank = false }
  | (Hash | Word), '#' -> { o with mode = Word; is_blank = false }
  | (Hash | Word), _ -> code { o with is_blank = false } c
  | Line, '\n' -> code o c
  | Line, _ -> o
  | Text { escaped = true }, _ -> { o with mode = Text { escaped = false } }
  | Text _, '\\' -> { o with mode = Text { escaped = true } }
  | Text _, '"' -> { o with mode = Code }
  | Text _, _ -> o
  | Block { depth; last = '|' }, '#' ->
      let mode =
        if depth = 1 then Code else Block { depth = depth - 1; last = ' ' }
      in
      { o with mode }
  | Block { depth; last = '#' }, '|' ->
      { o with mode = Block { depth = depth + 1; last = ' ' } }
  | Block { depth; _ }, '"' ->
      { o with mode = Block_text { depth; escaped = false } }
  | Block { depth; _ }, _ -> { o with mode = Block { depth; last = c } }
  | Block_text { depth; escaped = true }, _ ->
      { o with mode = Block_text { depth; escaped = false } }
  | Block_text { depth; _ }, '\\' ->
      { o with mode = Block_text { depth; escaped = true } }
  | Block_text { depth; _ }, '"' ->
      { o with mode = Block { depth; last = ' ' } }
  | Block_text _, _ -> o

let feed o c = { (step o c) with here = Span.after o.here c }

type unclosed =
  | Parenthesis of { opened : Span.t; doubt : int option }
  | Quotation of Span.t
  | Comment of Span.t
  | Nothing

let unclosed o =
  match (o.mode, o.doubt, o.opened) with
  | Text _, _, _ -> Quotation o.since
  | (Block _ | Block_text _), _, _ -> Comment o.since
  | (Code | Word | Hash | Line), Some (opened, line), _ :: _ ->
      Parenthesis { opened; doubt = Some line }
  | (Code | Word | Hash | Line), None, opened :: _ ->
      Parenthesis { opened; doubt = None }
  | (Code | Word | Hash | Line), _, [] -> Nothing
