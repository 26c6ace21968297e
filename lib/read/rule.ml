type t = (string * (float -> bool)) list
(** The first condition that does not hold is the one to tell. *)

let any = []

let length =
  [ ("must be at most 2^400 in size", fun x -> Float.abs x <= 0x1p400) ]

let above_zero = [ ("must be above 0", fun x -> x > 0.) ]
let not_negative = [ ("must not be negative", fun x -> x >= 0.) ]
let distance = not_negative @ length

let size =
  above_zero
  @ [ ("must be at least 2^-400", fun x -> x >= 0x1p-400) ]
  @ [ ("must be at most 2^400", fun x -> x <= 0x1p400) ]

let within a b =
  [ (Printf.sprintf "must be from %g to %g" a b, fun x -> a <= x && x <= b) ]

let between a b =
  let words = Printf.sprintf "must be above %g and below %g" a b in
  [ (words, fun x -> a < x && x < b) ]

let broken rule x =
  List.find_map
    (fun (words, holds) -> if holds x then None else Some words)
    rule
