type t = {
  span : Span.t option;
  message : string;
  hint : string option;
  distrust : int;
}

let v ?hint span message =
  { span = Some span; message; hint; distrust = max_int }

let unreadable message =
  { span = None; message; hint = None; distrust = max_int }

let closes_nothing e =
  String.equal (Parsexp.Parse_error.message e) "unexpected character: ')'"

let of_parser e =
  let span = Span.of_position (Parsexp.Parse_error.position e) in
  match Parsexp.Parse_error.message e with
  | _ when closes_nothing e -> v span "this `)` closes nothing"
  | "unexpected character after carriage return" ->
      v span "expected a line feed after a carriage return"
  | message -> v span message

let outline source ~bare start =
  let rec feed o =
    let first = (Outline.here o).offset in
    match Source.slice source ~first ~last:max_int with
    | "" -> o
    | text -> feed (String.fold_left Outline.feed o text)
  in
  feed (Outline.start ~bare start)

let unclosed source ~bare start ~otherwise =
  match Outline.unclosed (outline source ~bare start) with
  | Nothing -> otherwise
  | Quotation span -> v span "this string is never closed"
  | Comment span -> v span "this comment is never closed: expected `|#`"
  | Parenthesis { opened; doubt } ->
      let hint = Printf.sprintf "line %d begins as if it were" in
      let hint = Option.map hint doubt in
      {
        (v ?hint opened "this `(` is never closed") with
        distrust = opened.offset;
      }
