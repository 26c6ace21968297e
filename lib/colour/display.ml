let encode x =
  (* Written so that nan falls into the first branch. *)
  if not (x > 0.) then 0.
  else if x >= 1. then 255.
  else (x ** (1. /. 2.2)) *. 255.

let level x = int_of_float (encode x +. 0.5)
let decode n = (float_of_int n /. 255.) ** 2.2
