type point = float * float
type anchor = Start | Middle | End

let most = 1e6

let number x =
  let x =
    if Float.is_nan x then 0. else Float.max (-.most) (Float.min most x)
  in
  Printf.sprintf "%.1f" x

let drawing ~width ~height ~kind ~says parts =
  let box = Printf.sprintf "0 0 %s %s" (number width) (number height) in
  Markup.element "svg"
    [ ("viewBox", box); ("class", kind); ("role", "img"); ("aria-label", says) ]
    parts

let line kind (x1, y1) (x2, y2) =
  Markup.element "line"
    [
      ("class", kind);
      ("x1", number x1);
      ("y1", number y1);
      ("x2", number x2);
      ("y2", number y2);
    ]
    []

let path ?(closed = false) kind points =
  let pair (x, y) = number x ^ "," ^ number y in
  let name = if closed then "polygon" else "polyline" in
  let points = String.concat " " (List.map pair points) in
  Markup.element name [ ("class", kind); ("points", points) ] []

let circle kind (x, y) r =
  let attributes = [ ("cx", number x); ("cy", number y); ("r", number r) ] in
  Markup.element "circle" (("class", kind) :: attributes) []

let anchor = function Start -> "start" | Middle -> "middle" | End -> "end"

let text kind at (x, y) s =
  Markup.element "text"
    [
      ("class", kind);
      ("text-anchor", anchor at);
      ("x", number x);
      ("y", number y);
    ]
    [ Markup.text s ]

let hint s parts =
  Markup.element "g" [] (Markup.element "title" [] [ Markup.text s ] :: parts)

let window (x, y) (width, height) parts =
  Markup.element "svg"
    [
      ("x", number x);
      ("y", number y);
      ("width", number (Float.max 0. width));
      ("height", number (Float.max 0. height));
    ]
    parts
