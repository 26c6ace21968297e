let count = 61
let all = List.init count Fun.id
let modulo n = ((n mod count) + count) mod count
let of_pixel x y = modulo (x + (11 * y))

let advisers =
  ( [ (1, 0); (-1, 0); (1, 1); (-1, -1); (0, 2); (0, -2) ],
    [ (0, 1); (0, -1); (1, -1); (-1, 1); (2, 0); (-2, 0) ] )

let judges i =
  let advises (dx, dy) = modulo (i - of_pixel dx dy) in
  let first, second = advisers in
  let not_asked = i :: List.map advises (first @ second) in
  List.filter (fun j -> not (List.mem j not_asked)) all

let is_in (w : Window.t) i =
  let rows = List.init (Int.min count (Window.height w)) (fun j -> w.y0 + j) in
  let is_at y = modulo (i - of_pixel w.x0 y) < Window.width w in
  List.exists is_at rows
