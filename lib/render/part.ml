let count = 61
let all = List.init count Fun.id
let modulo n = ((n mod count) + count) mod count
let of_pixel x y = modulo (x + (11 * y))

let advisers =
  ( [ (1, 0); (-1, 0); (1, 1); (-1, -1); (0, 2); (0, -2) ],
    [ (0, 1); (0, -1); (1, -1); (-1, 1); (2, 0); (-2, 0) ] )

(* Offsets come in opposite pairs: it advises those that advise it. *)
let judges =
  let first, second = advisers in
  let of_part i =
    let near (dx, dy) = modulo (i + of_pixel dx dy) in
    let not_asked = i :: List.map near (first @ second) in
    List.filter (fun j -> not (List.mem j not_asked)) all
  in
  let lists = Array.init count of_part in
  fun i -> lists.(i)

(* Steps of 8 parts leave the least distance to those that had their turn, on
   average; 8 times 23 is one more than 3 times 61. *)
let turn i = modulo (23 * i)

let is_in (w : Window.t) i =
  let rows = List.init (Int.min count (Window.height w)) (fun j -> w.y0 + j) in
  let is_at y = modulo (i - of_pixel w.x0 y) < Window.width w in
  List.exists is_at rows
