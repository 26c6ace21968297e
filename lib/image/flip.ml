open Candor_colour

type t = { ppd : float; map : Plane.t }

let default_ppd = 0.7 *. (3840. /. 0.7) *. (Float.pi /. 180.)
let ppd_range = (1., 1000.)

(* {1 What is shown} *)

type shown = { width : int; height : int; light : int -> int -> Rgb.t }

let levels r =
  let full = Raster.maxval r in
  let table =
    Float.Array.init (full + 1) (fun n ->
        Flip_colour.linear_of_srgb (float_of_int n /. float_of_int full))
  in
  let light x y =
    let channel c = Float.Array.get table (Raster.sample r x y c) in
    Rgb.v (channel 0) (channel 1) (channel 2)
  in
  { width = Raster.width r; height = Raster.height r; light }

let radiance p =
  let shown v = Flip_colour.linear_of_srgb (Display.encode v /. 255.) in
  let light x y =
    let { Rgb.r; g; b } = Picture.pixel p x y in
    Rgb.v (shown r) (shown g) (shown b)
  in
  { width = Picture.width p; height = Picture.height p; light }

let shown = function
  | Picture_file.Display raster -> levels raster
  | Linear picture -> radiance picture

(* {1 Kernels} *)

type kernels = {
  y : floatarray list;
  cx : floatarray list;
  cz : floatarray list;
  smooth : floatarray;
  edge : floatarray;
  point : floatarray;
}

let kernels ~ppd =
  {
    y = Flip_filter.achromatic ~ppd;
    cx = Flip_filter.red_green ~ppd;
    cz = Flip_filter.blue_yellow ~ppd;
    smooth = Flip_filter.smooth ~ppd;
    edge = Flip_filter.edge ~ppd;
    point = Flip_filter.point ~ppd;
  }

let blurred rows plane =
  let once row = Plane.across row (Plane.across row plane) in
  match rows with
  | [] -> plane
  | first :: others ->
      List.fold_left
        (fun sum row -> Plane.add sum (once row))
        (once first) others

(* {1 Colours} *)

type opponents = { ys : Plane.t; cxs : Plane.t; czs : Plane.t }

let blurred_colours k o =
  { ys = blurred k.y o.ys; cxs = blurred k.cx o.cxs; czs = blurred k.cz o.czs }

let seen o i =
  Flip_colour.seen
    (Flip_colour.light
       { y = Plane.get o.ys i; cx = Plane.get o.cxs i; cz = Plane.get o.czs i })

let compressed distance = distance ** 0.7

(* Between green and blue, no colours of a display being further apart. *)
let farthest =
  let green = Flip_colour.seen (Rgb.v 0. 1. 0.)
  and blue = Flip_colour.seen (Rgb.v 0. 0. 1.) in
  compressed (Flip_colour.distance green blue)

(* Large distances are told apart less well than small ones: the first 0.4 of
   the range take 0.95 of the scale. *)
let redistributed distance =
  let knee = 0.4 *. farthest and level = 0.95 in
  let d = compressed distance in
  if d < knee then level *. d /. knee
  else level +. ((1. -. level) *. (d -. knee) /. (farthest -. knee))

let colour_difference a b i =
  redistributed (Flip_colour.distance (seen a i) (seen b i))

(* {1 Features} *)

let length x y i =
  let x = Plane.get x i and y = Plane.get y i in
  sqrt ((x *. x) +. (y *. y))

type features = { edges : int -> float; points : int -> float }

let features k { ys; _ } =
  let brightness =
    Plane.init ~width:(Plane.width ys) ~height:(Plane.height ys) (fun i ->
        Flip_colour.brightness (Plane.get ys i))
  in
  let smooth = Plane.across k.smooth brightness in
  let both kernel =
    length
      (Plane.across k.smooth (Plane.across kernel brightness))
      (Plane.across kernel smooth)
  in
  { edges = both k.edge; points = both k.point }

let feature_difference a b i =
  let edge = Float.abs (a.edges i -. b.edges i)
  and point = Float.abs (a.points i -. b.points i) in
  sqrt (Float.max edge point /. sqrt 2.)

(* {1 The difference} *)

let in_unit v = Float.min 1. (Float.max 0. v)

let difference k a b =
  let feature = feature_difference (features k a) (features k b) in
  let colour = colour_difference (blurred_colours k a) (blurred_colours k b) in
  Plane.init ~width:(Plane.width a.ys) ~height:(Plane.height a.ys) (fun i ->
      (* Rounding must not lead out of the range. *)
      in_unit (colour i) ** (1. -. in_unit (feature i)))

let opponents s ~first ~count =
  let row y = Int.max 0 (Int.min (s.height - 1) (first + y)) in
  let at x y =
    let { Flip_colour.y; cx; cz } = Flip_colour.opponent (s.light x (row y)) in
    (y, cx, cz)
  in
  let ys, cxs, czs = Plane.init3 ~width:s.width ~height:count at in
  { ys; cxs; czs }

(* So many rows at once that memory does not grow with the pictures: with the
   rows around them they give the same bits as the whole would. *)
let rows_at_once = 256
let reach = Flip_filter.reach

let band k ~margin a b first =
  let count = Int.min rows_at_once (a.height - first) in
  let around s =
    opponents s ~first:(first - margin) ~count:(count + (2 * margin))
  in
  Plane.rows ~first:margin ~count (difference k (around a) (around b))

let v ~ppd a b =
  let least, most = ppd_range in
  if not (ppd >= least && ppd <= most) then invalid_arg "Flip.v: ppd";
  let a = shown a and b = shown b in
  if a.width <> b.width || a.height <> b.height then
    Error
      (Printf.sprintf "the pictures differ in size: %dx%d and %dx%d" a.width
         a.height b.width b.height)
  else
    let count = (a.height + rows_at_once - 1) / rows_at_once in
    let band = band (kernels ~ppd) ~margin:(reach ~ppd) a b in
    let map =
      Plane.stack (List.init count (fun i -> band (i * rows_at_once)))
    in
    Ok { ppd; map }

(* {1 Results} *)

let ppd f = f.ppd
let mean f = Plane.mean f.map
let width f = Plane.width f.map
let height f = Plane.height f.map

let at f x y =
  if x < 0 || x >= width f then invalid_arg "Flip.at: outside";
  Plane.get f.map ((y * width f) + x)

let heatmap (format : Picture_file.format) f =
  let colour =
    match format with Ppm | Png -> Magma.colour | Pfm -> Rgb.grey
  in
  Picture.init ~width:(width f) ~height:(height f) (fun x y ->
      colour (at f x y))

let to_text f =
  let tenths = Float.round (10. *. f.ppd) /. 10. in
  Printf.sprintf "flip       %.6g (%g pixels per degree)\n" (mean f) tenths
