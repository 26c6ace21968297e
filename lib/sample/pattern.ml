type t = { seed : int; spp : int; columns : int; rows : int }
type position = { u : float; v : float }

let make ~seed ~spp =
  let columns = Int.max 1 (int_of_float (sqrt (float_of_int spp))) in
  { seed; spp; columns; rows = (spp + columns - 1) / columns }

(* i + f, which may round to i + 1 for f just below 1, stays below it. *)
let within i f =
  let next = float_of_int (i + 1) in
  Float.min (float_of_int i +. f) (Float.pred next)

let ratio a b = a /. float_of_int b

let position p ~x ~y sample =
  let pixel = Key.v ~seed:p.seed ~x ~y ~sample:0 ~bounce:0 Film in
  let jitter = Key.v ~seed:p.seed ~x ~y ~sample:(sample + 1) ~bounce:0 Film in
  let s = Key.permute pixel ~length:p.spp sample in
  let column =
    Key.permute (Key.derive pixel 0) ~length:p.columns (s mod p.columns)
  and row = Key.permute (Key.derive pixel 1) ~length:p.rows (s / p.columns) in
  let in_cell = ratio (within row (Key.float (Key.derive jitter 0))) p.rows in
  let in_row = within s (Key.float (Key.derive jitter 1)) in
  { u = ratio (within column in_cell) p.columns; v = ratio in_row p.spp }

let tent u =
  if u < 0.5 then sqrt (2. *. u) -. 1. else 1. -. sqrt (2. *. (1. -. u))
