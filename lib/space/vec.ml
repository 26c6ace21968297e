type t = { x : float; y : float; z : float } [@@deriving show, eq, ord]

let[@inline] v x y z = { x; y; z }
let zero = v 0. 0. 0.
let[@inline] neg a = v (-.a.x) (-.a.y) (-.a.z)
let[@inline] add a b = v (a.x +. b.x) (a.y +. b.y) (a.z +. b.z)
let[@inline] sub a b = v (a.x -. b.x) (a.y -. b.y) (a.z -. b.z)
let[@inline] scale k a = v (k *. a.x) (k *. a.y) (k *. a.z)

let[@inline] along a d t =
  v (Float.fma t d.x a.x) (Float.fma t d.y a.y) (Float.fma t d.z a.z)

(* 2^e for -1022 <= e <= 1023, from its bits. *)
let[@inline] power e =
  Int64.float_of_bits (Int64.shift_left (Int64.of_int (e + 1023)) 52)

(* Where the power is a normal number, the product is rounded as it should. *)
let ldexp e a =
  if -1022 <= e && e <= 1023 then scale (power e) a
  else v (Float.ldexp a.x e) (Float.ldexp a.y e) (Float.ldexp a.z e)

let[@inline] dot a b = (a.x *. b.x) +. (a.y *. b.y) +. (a.z *. b.z)

let[@inline] cross a b =
  v
    ((a.y *. b.z) -. (a.z *. b.y))
    ((a.z *. b.x) -. (a.x *. b.z))
    ((a.x *. b.y) -. (a.y *. b.x))

let abs a = v (Float.abs a.x) (Float.abs a.y) (Float.abs a.z)
let[@inline] norm1 a = Float.abs a.x +. Float.abs a.y +. Float.abs a.z

let largest a =
  let x = Float.abs a.x and y = Float.abs a.y and z = Float.abs a.z in
  let m = if x > y then x else y in
  if m > z then m else z

(* The exponent's own bits; where they are 0 the number is not normal. *)
let exponent a =
  let m = largest a in
  let bits = Int64.bits_of_float m in
  let e = Int64.to_int (Int64.shift_right_logical bits 52) land 0x7ff in
  if e = 0 || e = 0x7ff then snd (Float.frexp m) else e - 1022

(* Squares of numbers in this range neither overflow nor lose their bits. *)
let safe m = m > 0x1p-400 && m < 0x1p400

let[@inline never] extreme_norm a =
  let m = largest a in
  if m = 0. || not (Float.is_finite m) then m
  else if safe m then sqrt (dot a a)
  else
    let _, e = Float.frexp m in
    let a =
      v (Float.ldexp a.x (-e)) (Float.ldexp a.y (-e)) (Float.ldexp a.z (-e))
    in
    Float.ldexp (sqrt (dot a a)) e

(* Only numbers that are safe have such squares. *)
let[@inline] has_plain_square d = d > 0x1p-600 && d < 0x1p600

(* The product with 1 makes both cases numbers without a box. *)
let[@inline] norm a =
  let d = dot a a in
  if has_plain_square d then sqrt d else 1. *. extreme_norm a

let is_finite a =
  Float.is_finite a.x && Float.is_finite a.y && Float.is_finite a.z

let[@inline] get a i = if i = 0 then a.x else if i = 1 then a.y else a.z
