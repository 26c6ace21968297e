open Candor_image

type t = { share : float -> float; marks : (float * string) list }
(* A number's share of the way through the colours; numbers, as text, by it. *)

(* By doublings, from [low] to [high]. *)
let doublings low high write =
  let steps = Float.log2 (high /. low) in
  let share x = if x > 0. then Float.log2 (x /. low) /. steps else 0. in
  let mark i =
    let share = float_of_int i /. steps in
    (share, write (low *. (2. ** float_of_int i)))
  in
  { share; marks = List.init (int_of_float steps + 1) mark }

let errors = doublings 0.25 64. Amount.target
let shares = doublings 0.125 8. Amount.target
let size p = Plane.width p * Plane.height p

let top p =
  let finite =
    List.init (size p) (Plane.get p) |> List.filter Float.is_finite
  in
  match List.sort Float.compare finite with
  | [] -> 0.
  | sorted -> List.nth sorted (99 * (List.length sorted - 1) / 100)

let seconds p =
  let top = top p in
  if top > 0. then
    let mark share = (share, Amount.seconds (share *. top)) in
    { share = (fun s -> s /. top); marks = List.map mark [ 0.; 0.5; 1. ] }
  else { share = (fun _ -> 0.); marks = [ (0., Amount.seconds 0.) ] }

let map h p =
  let width = Plane.width p in
  Picture.init ~width ~height:(Plane.height p) (fun x y ->
      Magma.colour (h.share (Plane.get p ((y * width) + x))))

let image ~says p =
  let data = "data:image/png;base64," ^ Base64.encode (Png.encode p) in
  Markup.void "img"
    [
      ("src", data);
      ("alt", says);
      ("width", string_of_int (Picture.width p));
      ("height", string_of_int (Picture.height p));
    ]

let strip =
  Picture.init ~width:256 ~height:1 (fun x _ ->
      Magma.colour (float_of_int x /. 255.))

let marks all =
  let mark (share, says) =
    let at = Printf.sprintf "left:%s%%" (Svg.number (100. *. share)) in
    Markup.element "span" [ ("style", at) ] [ Markup.text says ]
  in
  Markup.element "div" [ ("class", "marks") ] (List.map mark all)

let legend h =
  Markup.element "div"
    [ ("class", "legend") ]
    [ image ~says:"from the least to the most" strip; marks h.marks ]
