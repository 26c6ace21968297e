external swap_bytes : int64 -> int64 = "%bswap_int64"

(* Numbers of 64 bits, which have no box within a function, are free of tags. *)
let[@inline] swap x mask s =
  let open Int64 in
  logor (logand (shift_right_logical x s) mask) (shift_left (logand x mask) s)

(* The low 32 bits in reverse order: those of each byte, and the bytes. *)
let[@inline] reverse x =
  let x = swap (Int64.of_int x) 0x55555555L 1 in
  let x = swap x 0x33333333L 2 in
  let x = swap x 0x0f0f0f0fL 4 in
  Int64.to_int (Int64.shift_right_logical (swap_bytes x) 32)

(* Each bit of the result is the bit of [x], flipped or not by a hash of the
   bits below it: nested scrambling of digits in reverse order. Bits from 32 on,
   0 in [x], become digits past those that [x] has. *)
let[@inline] scramble k x =
  let x = x lxor (x * 0x3d20adea) in
  let x = (x + k) * ((k lsr 16) lor 1) in
  let x = x lxor (x * 0x05526c56) in
  x lxor (x * 0x53a22864)

(* The Pascal matrix mod 2: bit i of the result is the sum of bits j of [x] over
   all j with C(j, i) odd, which is where i has no bit that j has not. *)
let[@inline] pascal x =
  let x = x lxor ((x lsr 1) land 0x55555555) in
  let x = x lxor ((x lsr 2) land 0x33333333) in
  let x = x lxor ((x lsr 4) land 0x0f0f0f0f) in
  let x = x lxor ((x lsr 8) land 0x00ff00ff) in
  x lxor ((x lsr 16) land 0x0000ffff)

(* A number whose first 32 digits are bits 0, 1, … of [x] and whose next 21 are
   bits 32 to 52, which are as good in any order. *)
let[@inline] fraction x =
  let digits = (reverse x lsl 21) lor ((x lsr 32) land 0x1fffff) in
  float_of_int digits *. 0x1p-53

(* Scrambled as if it were a fraction, an index stays in its block of any size
   2^k. *)
let[@inline] shuffle (key : Key.t) i =
  reverse (scramble (Key.derive key 0 :> int) (reverse i))

let[@inline] digits (key : Key.t) purpose x =
  fraction (scramble (Key.derive key purpose :> int) x)

let pair ~key i =
  let i = shuffle key i in
  { Pattern.u = digits key 1 i; v = digits key 2 (pascal i) }

let one ~key i = digits key 1 (shuffle key i)
