open Candor_space

type t = int

let none = -1

let[@inline] v ~part (side : Side.t) =
  (2 * part) + match side with Outside -> 0 | Inside -> 1

let[@inline] is_none c = c < 0
let part c = c asr 1
let side c : Side.t = if c land 1 = 0 then Outside else Inside
