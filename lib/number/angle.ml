let pi = Float.pi
let radians a = a *. (pi /. 180.)

(* The remainder is exact; what is left is at most 45 degrees from an axis. *)
let split a =
  let a = Float.rem a 360. in
  let quarter = Float.round (a /. 90.) in
  (((int_of_float quarter mod 4) + 4) mod 4, radians (a -. (quarter *. 90.)))

let sin a =
  match split a with
  | 0, r -> Stdlib.sin r
  | 1, r -> Stdlib.cos r
  | 2, r -> -.Stdlib.sin r
  | _, r -> -.Stdlib.cos r

let cos a =
  match split a with
  | 0, r -> Stdlib.cos r
  | 1, r -> -.Stdlib.sin r
  | 2, r -> -.Stdlib.cos r
  | _, r -> Stdlib.sin r

let tan a =
  match Float.rem a 180. with
  | 0. -> 0.
  | 45. | -135. -> 1.
  | 135. | -45. -> -1.
  | _ -> sin a /. cos a
