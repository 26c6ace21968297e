(** Exact numbers m·2^e: what doubles are, and all that sums and products make
    of them. Faster than rationals, since nothing is ever reduced. *)

type t = { m : Z.t; e : int }

let zero = { m = Z.zero; e = 0 }
let one = { m = Z.one; e = 0 }
let of_z m = { m; e = 0 }
let of_int n = of_z (Z.of_int n)

(** [power k] is 2^k. *)
let power k = { m = Z.one; e = k }

(** [of_float x] is [x], which must be finite. *)
let of_float x =
  if not (Float.is_finite x) then invalid_arg "Dyadic.of_float"
  else
    let m, e = Float.frexp x in
    { m = Z.of_int (int_of_float (Float.ldexp m 53)); e = e - 53 }

let sign a = Z.sign a.m
let neg a = { a with m = Z.neg a.m }
let abs a = { a with m = Z.abs a.m }

(** [shift k a] is 2^k·a. *)
let shift k a = { a with e = a.e + k }

let aligned op a b =
  if Z.sign b.m = 0 then { a with m = op a.m Z.zero }
  else if Z.sign a.m = 0 then { b with m = op Z.zero b.m }
  else if a.e = b.e then { a with m = op a.m b.m }
  else if a.e > b.e then { b with m = op (Z.shift_left a.m (a.e - b.e)) b.m }
  else { a with m = op a.m (Z.shift_left b.m (b.e - a.e)) }

let ( + ) a b = aligned Z.add a b
let ( - ) a b = aligned Z.sub a b

let ( * ) a b =
  if a == one then b
  else if b == one then a
  else { m = Z.mul a.m b.m; e = Int.add a.e b.e }

(* Where signs and sizes do not decide, the difference does. *)
let compare a b =
  let sa = sign a and sb = sign b in
  if sa <> sb || sa = 0 then Int.compare sa sb
  else
    let top x = Int.add (Z.numbits x.m) x.e in
    match Int.compare (top a) (top b) with
    | 0 -> sign (a - b)
    | by_size -> Int.mul sa by_size

let leq a b = compare a b <= 0
let max a b = if leq a b then b else a
let min a b = if leq a b then a else b

(** [to_q a] is [a]. *)
let to_q { m; e } =
  if e >= 0 then Q.of_bigint (Z.shift_left m e)
  else Q.make m (Z.shift_left Z.one (-e))

(** [fraction q] is (n, d) with [d > 0] and n/d = [q]. *)
let fraction q = ({ m = Q.num q; e = 0 }, { m = Q.den q; e = 0 })

(** [split a] is (x, e) with x·2^e within 2^-53 of [a], relatively, and x in
    \[1/2;1\] or zero. *)
let split { m; e } =
  let n = Z.numbits m in
  if n <= 62 then
    let x, k = Float.frexp (Z.to_float m) in
    (x, Int.add k e)
  else
    let cut = Int.sub n 62 in
    let x, k = Float.frexp (Z.to_float (Z.shift_right m cut)) in
    (x, Int.add k (Int.add e cut))
