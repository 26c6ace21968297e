open Candor_space
open Candor_colour
open Candor_scene
open Candor_sample

(* [cells] has a column for each texel, from its centre to the next one's, and
   height + 1 rows, whose borders are the poles and the centres of texels. *)
type t = {
  texels : Texels.t;
  cells : Distribution.square;
  borders : floatarray;  (** sin²(θ/2) at the upper border of each row, and 1 *)
  angles : floatarray;  (** the solid angle of a cell in each row *)
}

type sample = { direction : Dir.t; radiance : Rgb.t; density : float }

let rows texels = Texels.height texels + 1

(* The angle from straight up to the upper border of row [k]. *)
let border texels k =
  let height = Texels.height texels in
  if k = 0 then 0.
  else if k > height then Float.pi
  else Float.pi *. (float_of_int k -. 0.5) /. float_of_int height

(* The solid angle of a cell in row [k]: (2π/width)·(cos a − cos b), without
   cancellation at the poles. *)
let solid_angle texels k =
  let a = border texels k and b = border texels (k + 1) in
  let zone = 2. *. sin (0.5 *. (a +. b)) *. sin (0.5 *. (b -. a)) in
  2. *. Float.pi *. zone /. float_of_int (Texels.width texels)

(* Of Rec. 709 primaries. *)
let luminance (c : Rgb.t) = (0.2126 *. c.r) +. (0.7152 *. c.g) +. (0.0722 *. c.b)

(* sin²(θ/2) is uniform over solid angle, and exact at the upper pole. *)
let half_square angle =
  let s = sin (0.5 *. angle) in
  s *. s

let weights texels angles =
  let width = Texels.width texels and height = Texels.height texels in
  let weight i =
    let x = i mod width and k = i / width in
    let right = if x + 1 < width then x + 1 else 0 in
    let above = Int.max 0 (k - 1) and below = Int.min k (height - 1) in
    let at x y = luminance (Texels.get texels x y) in
    let mean =
      0.25 *. (at x above +. at right above +. at x below +. at right below)
    in
    mean *. Float.Array.get angles k
  in
  Float.Array.init (width * rows texels) weight

let make texels =
  let rows = rows texels in
  let angles = Float.Array.init rows (solid_angle texels) in
  let border k = half_square (border texels k) in
  let borders = Float.Array.init (rows + 1) border in
  weights texels angles
  |> Distribution.square ~columns:(Texels.width texels)
  |> Option.map (fun cells -> { texels; cells; borders; angles })

(* The row of cells at [v] from the bottom, the column at [u]. *)
let row texels v =
  let height = Texels.height texels in
  let y = (1. -. v) *. float_of_int height in
  Int.min height (int_of_float (y +. 0.5))

let column texels u =
  let width = Texels.width texels in
  let i = int_of_float (Float.floor ((u *. float_of_int width) -. 0.5)) in
  if i < 0 then width - 1 else i

let density_at t { Texels.u; v } =
  let k = row t.texels v and i = column t.texels u in
  let width = float_of_int (Texels.width t.texels)
  and rows = float_of_int (rows t.texels) in
  let middle =
    {
      Pattern.u = (float_of_int i +. 0.5) /. width;
      v = (float_of_int k +. 0.5) /. rows;
    }
  in
  let chance = Distribution.density t.cells middle /. (width *. rows) in
  chance /. Float.Array.get t.angles k

let density t (d : Dir.t) = density_at t (Texels.towards (d :> Vec.t))

(* The direction at [x] columns from the left and [y] rows from the top. *)
let direction t x y =
  let k = Int.min (int_of_float y) (Texels.height t.texels) in
  let a = Float.Array.get t.borders k
  and b = Float.Array.get t.borders (k + 1) in
  let q = a +. ((y -. float_of_int k) *. (b -. a)) in
  let across = 2. *. sqrt (q *. (1. -. q)) in
  let turn = ((x +. 0.5) /. float_of_int (Texels.width t.texels)) -. 0.5 in
  let azimuth = 2. *. Float.pi *. turn in
  Dir.of_vec_or Dir.y
    (Vec.v (across *. sin azimuth) (1. -. (2. *. q)) (-.across *. cos azimuth))

let sample t ~u ~v =
  let cell = Distribution.place t.cells { Pattern.u; v } in
  let direction =
    direction t
      (cell.u *. float_of_int (Texels.width t.texels))
      (cell.v *. float_of_int (rows t.texels))
  in
  let place = Texels.towards (direction :> Vec.t) in
  let density = density_at t place in
  if density > 0. then
    let radiance = Texels.radiance_at t.texels place in
    Some { direction; radiance; density }
  else None
