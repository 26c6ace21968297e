type purpose =
  | Film
  | Path
  | Lens
  | Shutter
  | Emitter
  | Emitter_direction
  | Sky_direction
  | Lobe
  | Bounce
  | Survival
  | Reflected
  | Transmitted
  | Boundary
  | Wavelength
  | Distance
  | Deflection
  | Share
[@@deriving show, eq, ord]

type t = int

(* A finaliser in the manner of G. Steele, D. Lea, C. Flood, Fast Splittable
   Pseudorandom Number Generators, 2014, on OCaml's 63-bit integers. *)
let mix x =
  let x = x lxor (x lsr 31) * 0x3f58476d1ce4e5b9 in
  let x = x lxor (x lsr 28) * 0x14d049bb133111eb in
  x lxor (x lsr 32)

let gamma = 0x1e3779b97f4a7c15
let derive k i = mix (k + ((i + 1) * gamma))

let number = function
  | Film -> 1
  | Path -> 2
  | Lens -> 3
  | Shutter -> 4
  | Emitter -> 5
  | Emitter_direction -> 6
  | Sky_direction -> 7
  | Lobe -> 8
  | Bounce -> 9
  | Survival -> 10
  | Reflected -> 11
  | Transmitted -> 12
  | Boundary -> 13
  | Wavelength -> 14
  | Distance -> 15
  | Deflection -> 16
  | Share -> 17

let below k purpose = derive k (number purpose)

let v ~seed ~x ~y ~sample ~bounce purpose =
  let k = derive (mix seed) x in
  let k = derive k y in
  let k = derive k sample in
  below (derive k bounce) purpose

let float k = float_of_int (k land ((1 lsl 53) - 1)) *. 0x1p-53
let rec bits n b = if 1 lsl b >= n then b else bits n (b + 1)

(* A bijection on the [2 half] or [2 half - 1] bits of [mask]; [m1] and [m2] are
   odd. *)
let[@inline] step ~mask ~half ~m1 ~m2 s x =
  let x = (x + s) land mask in
  let x = x * m1 land mask in
  let x = x lxor (x lsr half) in
  let x = x * m2 land mask in
  let x = x lxor (x lsr half) in
  (x + (s lsr 3)) land mask

let rec walk ~mask ~half ~m1 ~m2 s ~length x =
  if x < length then x
  else walk ~mask ~half ~m1 ~m2 s ~length (step ~mask ~half ~m1 ~m2 s x)

(* The bijection on the least power of two that holds the length, walked until it
   falls inside, and then turned: however well the bijection mixes, each index
   goes everywhere equally often. *)
let permute k ~length i =
  let b = bits length 0 in
  let mask = (1 lsl b) - 1 and half = (b + 1) / 2 in
  let[@inline] odd n = derive k n lor 1 land mask in
  let m1 = odd 0 and m2 = odd 1 and s = derive k 2 land mask in
  let turn = derive k 3 land max_int mod length in
  let x = step ~mask ~half ~m1 ~m2 s i in
  (walk ~mask ~half ~m1 ~m2 s ~length x + turn) mod length
