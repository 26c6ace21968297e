type t = { low : float; high : float; from : float; into : float }
(* [low] and [high] are natural logarithms. *)

type place = At of float | Below | Above | Nowhere

let usable x = x > 0. && x < infinity

let v ~from ~into ~margin values =
  let logs = List.filter usable values |> List.map log in
  let margin = log margin in
  match logs with
  | [] -> { low = log 0.1; high = log 10.; from; into }
  | first :: rest ->
      let low = List.fold_left Float.min first rest
      and high = List.fold_left Float.max first rest in
      { low = low -. margin; high = high +. margin; from; into }

let along s l =
  s.from +. ((l -. s.low) /. (s.high -. s.low) *. (s.into -. s.from))

let place s x =
  if Float.is_nan x then Nowhere
  else if x <= 0. then Below
  else
    let l = log x in
    if l < s.low then Below else if l > s.high then Above else At (along s l)

let clamped s x =
  match place s x with
  | At c -> Some c
  | Below -> Some s.from
  | Above -> Some s.into
  | Nowhere -> None

let power s f = (f s.low, f s.high)

let log_coordinate s l =
  let reach = 10. *. (s.high -. s.low) in
  let l = if Float.is_nan l then s.low else l in
  along s (Float.max (s.low -. reach) (Float.min (s.high +. reach) l))

(* {1 Round numbers} *)

let on s x =
  match place s x with At _ -> true | Below | Above | Nowhere -> false

let decades s =
  let first = Float.floor (s.low /. log 10.) in
  let span = Float.ceil (s.high /. log 10.) -. first in
  let step = Float.ceil (span /. 10.) in
  let heads = if span <= 4. then [ 1.; 2.; 5. ] else [ 1. ] in
  List.init
    (int_of_float (span /. step) + 1)
    (fun i -> 10. ** (first +. (step *. float_of_int i)))
  |> List.concat_map (fun decade -> List.map (( *. ) decade) heads)
  |> List.filter (on s)

let minutes = [ 1.; 2.; 5.; 10.; 20.; 30.; 60.; 120.; 300.; 600.; 1440. ]

let times s =
  let longest = 1440. *. 60. in
  let short = List.filter (fun t -> t < 60.) (decades s) in
  let long = List.filter (on s) (List.map (( *. ) 60.) minutes) in
  let rest = List.filter (fun t -> t > 2. *. longest) (decades s) in
  short @ long @ rest
