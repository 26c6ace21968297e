open Candor_space
open Candor_sample

(* The midpoints of a cube's edges; four of them twice, so that a hash needs no
   division to choose among 16. *)
let gradients =
  Float.Array.of_list
    (List.concat
       [
         [ 1.; 1.; 0.; -1.; 1.; 0.; 1.; -1.; 0.; -1.; -1.; 0. ];
         [ 1.; 0.; 1.; -1.; 0.; 1.; 1.; 0.; -1.; -1.; 0.; -1. ];
         [ 0.; 1.; 1.; 0.; -1.; 1.; 0.; 1.; -1.; 0.; -1.; -1. ];
         [ 1.; 1.; 0.; -1.; 1.; 0.; 0.; -1.; 1.; 0.; -1.; -1. ];
       ])

let[@inline] slope (key : Key.t) x y z =
  let i = 3 * ((key :> int) land 15) in
  (Float.Array.get gradients i *. x)
  +. (Float.Array.get gradients (i + 1) *. y)
  +. (Float.Array.get gradients (i + 2) *. z)

let root = Key.v ~seed:2002 ~x:0 ~y:0 ~sample:0 ~bounce:0 Film
let period = 0x1p32

(* The cell of [x] along one axis, modulo the period: exact at any size. *)
let[@inline] cell floor =
  int_of_float (floor -. (period *. Float.floor (floor /. period)))

let[@inline] next i = if i = 0xffffffff then 0 else i + 1

(* [x - floor], or 0 where that is no number. *)
let[@inline] fraction x floor =
  let f = x -. floor in
  if f >= 0. then f else 0.

let[@inline] fade t = t *. t *. t *. ((t *. ((t *. 6.) -. 15.)) +. 10.)
let[@inline] blend s a b = a +. (s *. (b -. a))

(* Along one edge of a cell, in z. *)
let[@inline] edge column k x y z w =
  blend w
    (slope (Key.derive column k) x y z)
    (slope (Key.derive column (next k)) x y (z -. 1.))

let[@inline] noise layer x y z =
  let fx = Float.floor x and fy = Float.floor y and fz = Float.floor z in
  let i = cell fx and j = cell fy and k = cell fz in
  let x = fraction x fx and y = fraction y fy and z = fraction z fz in
  let u = fade x and v = fade y and w = fade z in
  let here = Key.derive layer i and there = Key.derive layer (next i) in
  0.9375
  *. blend u
       (blend v
          (edge (Key.derive here j) k x y z w)
          (edge (Key.derive here (next j)) k x (y -. 1.) z w))
       (blend v
          (edge (Key.derive there j) k (x -. 1.) y z w)
          (edge (Key.derive there (next j)) k (x -. 1.) (y -. 1.) z w))

let gradient ~layer (p : Point.t) = noise (Key.derive root layer) p.x p.y p.z

let fractal ~octaves (p : Point.t) =
  let sum = ref 0. and weights = ref 0. and size = ref 1. in
  for layer = 0 to Int.min 53 (Int.max 1 octaves) - 1 do
    let k = !size in
    let octave =
      noise (Key.derive root layer) (k *. p.x) (k *. p.y) (k *. p.z)
    in
    sum := !sum +. (octave /. k);
    weights := !weights +. (1. /. k);
    size := 2. *. k
  done;
  !sum /. !weights

let mix ~octaves p = 0.5 +. (0.5 *. fractal ~octaves p)
