let encode x =
  (* Written so that nan falls into the first branch. *)
  if not (x > 0.) then 0.
  else if x >= 1. then 255.
  else (x ** (1. /. 2.2)) *. 255.

let nearest shown = int_of_float (shown +. 0.5)
let level x = nearest (encode x)
let decode n = (float_of_int n /. 255.) ** 2.2
