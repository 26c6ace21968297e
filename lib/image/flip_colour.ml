open Candor_colour

let linear_of_srgb v =
  if v <= 0.04045 then v /. 12.92 else ((v +. 0.055) /. 1.055) ** 2.4

(* {1 XYZ} *)

(* The matrix of sRGB as fractions, and its inverse, as the authors of FLIP have
   them. White is the sum of a row, since Y of white is 1. *)
type xyz = { x : float; y : float; z : float }

let xyz { Rgb.r; g; b } =
  {
    x = ((10135552. *. r) +. (8788810. *. g) +. (4435075. *. b)) /. 24577794.;
    y = ((2613072. *. r) +. (8788810. *. g) +. (887015. *. b)) /. 12288897.;
    z = ((1425312. *. r) +. (8788810. *. g) +. (70074185. *. b)) /. 73733382.;
  }

let rgb { x; y; z } =
  Rgb.v
    ((3.241003275 *. x) -. (1.537398934 *. y) -. (0.498615861 *. z))
    ((-0.969224334 *. x) +. (1.875930071 *. y) +. (0.041554224 *. z))
    ((0.055639423 *. x) -. (0.204011202 *. y) +. (1.057148933 *. z))

let white = xyz Rgb.white

(* {1 YCxCz} *)

type opponent = { y : float; cx : float; cz : float }

let opponent light =
  let { x; y; z } = xyz light in
  let x = x /. white.x and z = z /. white.z in
  { y = (116. *. y) -. 16.; cx = 500. *. (x -. y); cz = 200. *. (y -. z) }

let brightness y = (y +. 16.) /. 116.

let light { y; cx; cz } =
  let y = brightness y in
  let x = white.x *. (y +. (cx /. 500.)) in
  let z = white.z *. (y -. (cz /. 200.)) in
  let { Rgb.r; g; b } = rgb { x; y; z } in
  let clamp v = Float.min 1. (Float.max 0. v) in
  Rgb.v (clamp r) (clamp g) (clamp b)

(* {1 CIELAB} *)

type seen = { l : float; a : float; b : float }

let lightness t =
  let delta = 6. /. 29. in
  if t > delta *. delta *. delta then Float.cbrt t
  else (t /. (3. *. delta *. delta)) +. (4. /. 29.)

let seen light =
  let { x; y; z } = xyz light in
  let x = lightness (x /. white.x)
  and y = lightness y
  and z = lightness (z /. white.z) in
  let l = (116. *. y) -. 16. in
  let hunt c = l /. 100. *. c in
  { l; a = hunt (500. *. (x -. y)); b = hunt (200. *. (y -. z)) }

let distance s t =
  let da = s.a -. t.a and db = s.b -. t.b in
  Float.abs (s.l -. t.l) +. sqrt ((da *. da) +. (db *. db))
