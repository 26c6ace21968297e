open Candor_space
open Candor_colour

(* Red, green and blue of each texel in turn, row by row. *)
type t = { width : int; height : int; values : floatarray }

let init ~width ~height f =
  if width < 1 || height < 1 then
    invalid_arg "Texels.init: at least one texel is needed each way";
  let values = Float.Array.create (3 * width * height) in
  for y = 0 to height - 1 do
    for x = 0 to width - 1 do
      let { Rgb.r; g; b } = f x y in
      let i = 3 * ((y * width) + x) in
      Float.Array.set values i r;
      Float.Array.set values (i + 1) g;
      Float.Array.set values (i + 2) b
    done
  done;
  { width; height; values }

let width t = t.width
let height t = t.height

let texel t i =
  let at c = Float.Array.get t.values ((3 * i) + c) in
  Rgb.v (at 0) (at 1) (at 2)

let get t x y =
  if x < 0 || x >= t.width || y < 0 || y >= t.height then
    invalid_arg "Texels.get: outside";
  texel t ((y * t.width) + x)

let exists p t =
  let rec from i = i < t.width * t.height && (p (texel t i) || from (i + 1)) in
  from 0

let greatest t =
  let texels = Seq.take (t.width * t.height) (Seq.ints 0) in
  Seq.fold_left (fun most i -> Rgb.greater most (texel t i)) (texel t 0) texels

let compare a b =
  let rec values i =
    if i = Float.Array.length a.values then 0
    else
      let x = Float.Array.get a.values i and y = Float.Array.get b.values i in
      match Float.compare x y with 0 -> values (i + 1) | order -> order
  in
  match Int.compare a.width b.width with
  | 0 -> (
      match Int.compare a.height b.height with 0 -> values 0 | order -> order)
  | order -> order

let equal a b = compare a b = 0

(* Equal numbers have equal hashes, -0. and 0. too. *)
let hash t =
  let next h x = ((h * 31) + Hashtbl.hash x) land 0x3fffffff in
  Float.Array.fold_left next 0 t.values

let show t = Printf.sprintf "(%dx%d texels #%x)" t.width t.height (hash t)
let pp out t = Format.pp_print_string out (show t)

(* a + s·(b − a) with s in [0;1[ never rounds above the greater of a and b. *)
let[@inline] mix s a b = a +. (s *. (b -. a))

let[@inline] value t c row column =
  Float.Array.get t.values ((3 * ((row * t.width) + column)) + c)

let[@inline] channel t c ~left ~right ~above ~below sx sy =
  mix sy
    (mix sx (value t c above left) (value t c above right))
    (mix sx (value t c below left) (value t c below right))

(* The colour at (x, y) counted in texels, 0 at the left or upper edge, x in
   [0;width], between these rows. *)
let[@inline] between t x ~above ~below sy =
  let x = x -. 0.5 in
  let first = Float.floor x in
  let i = int_of_float first and sx = x -. first in
  let left = if i < 0 then t.width - 1 else i in
  let right = if i + 1 < t.width then i + 1 else 0 in
  Rgb.v
    (channel t 0 ~left ~right ~above ~below sx sy)
    (channel t 1 ~left ~right ~above ~below sx sy)
    (channel t 2 ~left ~right ~above ~below sx sy)

(* What is left of x beyond whole numbers, in [0;1]. *)
let[@inline] fraction x =
  let f = x -. Float.floor x in
  if f >= 0. then f else 0.

let bilinear_repeating t ~u ~v =
  let y = ((1. -. fraction v) *. float_of_int t.height) -. 0.5 in
  let first = Float.floor y in
  let j = int_of_float first in
  let above = if j < 0 then t.height - 1 else j in
  let below = if j + 1 < t.height then j + 1 else 0 in
  between t (fraction u *. float_of_int t.width) ~above ~below (y -. first)

type place = { u : float; v : float }

(* Angles from atan2, which is right to the last bits at the poles too. *)
let[@inline] turn (d : Vec.t) = 0.5 +. (atan2 d.x (-.d.z) /. (2. *. Float.pi))

let[@inline] fall (d : Vec.t) =
  atan2 (Vec.norm (Vec.v d.x 0. d.z)) d.y /. Float.pi

let towards d = { u = turn d; v = 1. -. fall d }

let radiance_at t { u; v } =
  let y = ((1. -. v) *. float_of_int t.height) -. 0.5 in
  let first = Float.floor y in
  let j = int_of_float first in
  let above = if j < 0 then 0 else j in
  let below = if j + 1 < t.height then j + 1 else t.height - 1 in
  between t (u *. float_of_int t.width) ~above ~below (y -. first)

let radiance t d = radiance_at t (towards d)
