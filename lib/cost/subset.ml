open Candor_sample

type t = {
  full_width : int;
  full_height : int;
  width : int;
  height : int;
  seed : int;
}

let make ~width ~height ~seed ~pixels =
  let side =
    sqrt (float_of_int (width * height) /. float_of_int (Int.max 1 pixels))
  in
  let blocks n =
    Int.max 1 (Int.min n (int_of_float (float_of_int n /. side)))
  in
  {
    full_width = width;
    full_height = height;
    width = blocks width;
    height = blocks height;
    seed;
  }

let width s = s.width
let height s = s.height
let count s = s.width * s.height

(* A place in the [i]-th of [blocks] parts of [n] places. *)
let place key ~blocks n i =
  let first = i * n / blocks and next = (i + 1) * n / blocks in
  let size = next - first in
  let within = int_of_float (Key.float key *. float_of_int size) in
  first + Int.min (size - 1) within

let pixel s i =
  let column = i mod s.width and row = i / s.width in
  let key axis =
    let key = Key.v ~seed:s.seed ~x:column ~y:row ~sample:0 ~bounce:0 Film in
    Key.derive key axis
  in
  ( place (key 0) ~blocks:s.width s.full_width column,
    place (key 1) ~blocks:s.height s.full_height row )

let share s =
  float_of_int (count s) /. float_of_int (s.full_width * s.full_height)
