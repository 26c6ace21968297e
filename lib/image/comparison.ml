open Candor_colour

type measure = Levels | Radiance [@@deriving show, eq]

type t = {
  width : int;
  height : int;
  measure : measure;
  rmse : float;
  mae : float;
  max : float;
  rel_mse : float;
  non_finite : int;
}
[@@deriving show, eq]

type source = {
  columns : int;
  rows : int;
  full : float;  (** full brightness. *)
  pixel : int -> int -> Rgb.t;
}

let levels raster x y =
  let value c =
    float_of_int (Raster.sample raster x y c)
    *. 255.
    /. float_of_int (Raster.maxval raster)
  in
  Rgb.v (value 0) (value 1) (value 2)

let display r =
  {
    columns = Raster.width r;
    rows = Raster.height r;
    full = 255.;
    pixel = levels r;
  }

let linear p =
  {
    columns = Picture.width p;
    rows = Picture.height p;
    full = 1.;
    pixel = Picture.pixel p;
  }

(* |a - b|, where a value is at distance 0 from itself even if not finite. *)
let distance a b = if Float.equal a b then 0. else Float.abs (a -. b)

let relative ~full d b =
  (* Where b is infinite or nan, d is 0, infinite or nan, and says it all. *)
  if Float.is_finite b then d *. d /. ((b *. b) +. (0.001 *. full *. full))
  else d

type sums = {
  squares : float;
  absolutes : float;
  largest : float;
  relatives : float;
}

let none = { squares = 0.; absolutes = 0.; largest = 0.; relatives = 0. }

let join s t =
  {
    squares = s.squares +. t.squares;
    absolutes = s.absolutes +. t.absolutes;
    largest = Float.max s.largest t.largest (* nan if either is *);
    relatives = s.relatives +. t.relatives;
  }

let channel ~full a b =
  let d = distance a b in
  {
    squares = d *. d;
    absolutes = d;
    largest = d;
    relatives = relative ~full d b;
  }

let pixel ~full (a : Rgb.t) (b : Rgb.t) =
  join (channel ~full a.r b.r)
    (join (channel ~full a.g b.g) (channel ~full a.b b.b))

let fold n f start = Seq.fold_left f start (Seq.take n (Seq.ints 0))

let sums a b =
  let at y total x =
    join total (pixel ~full:b.full (a.pixel x y) (b.pixel x y))
  in
  fold b.rows (fun total y -> join total (fold b.columns (at y) none)) none

let count_non_finite a b =
  let finite x y = Rgb.is_finite (a.pixel x y) && Rgb.is_finite (b.pixel x y) in
  let at y count x = if finite x y then count else count + 1 in
  fold b.rows (fun count y -> fold b.columns (at y) count) 0

let compare_sources measure a b =
  if a.columns <> b.columns || a.rows <> b.rows then
    Error
      (Printf.sprintf "the pictures differ in size: %dx%d and %dx%d" a.columns
         a.rows b.columns b.rows)
  else
    let { squares; absolutes; largest; relatives } = sums a b in
    let count = float_of_int (3 * b.columns * b.rows) in
    Ok
      {
        width = b.columns;
        height = b.rows;
        measure;
        rmse = sqrt (squares /. count);
        mae = absolutes /. count;
        max = largest;
        rel_mse = relatives /. count;
        non_finite = count_non_finite a b;
      }

let v (a : Picture_file.content) (b : Picture_file.content) =
  match (a, b) with
  | Display a, Display b -> compare_sources Levels (display a) (display b)
  | Linear a, Linear b -> compare_sources Radiance (linear a) (linear b)
  | Display _, Linear _ | Linear _, Display _ ->
      Error
        "one picture is linear (PFM) and the other is not (PPM or PNG): write \
         both in the same kind of format"

let within e c = c.rmse <= e
let unit_name = function Levels -> "1/255" | Radiance -> "linear"

let to_text c =
  let unit = unit_name c.measure in
  String.concat ""
    [
      Printf.sprintf "size       %dx%d\n" c.width c.height;
      Printf.sprintf "rmse       %.6g (%s)\n" c.rmse unit;
      Printf.sprintf "mae        %.6g (%s)\n" c.mae unit;
      Printf.sprintf "max        %.6g (%s)\n" c.max unit;
      Printf.sprintf "rel mse    %.6g\n" c.rel_mse;
      Printf.sprintf "non-finite %d pixels\n" c.non_finite;
    ]

let json_number x =
  if not (Float.is_finite x) then "null"
  else
    let short = Printf.sprintf "%.15g" x in
    if Float.equal (float_of_string short) x then short
    else Printf.sprintf "%.17g" x

let to_json ?(also = []) c =
  let more (key, x) = Printf.sprintf {|,"%s":%s|} key (json_number x) in
  Printf.sprintf
    {|{"width":%d,"height":%d,"unit":"%s","rmse":%s,"mae":%s,"max":%s,"rel_mse":%s,"non_finite":%d%s}|}
    c.width c.height (unit_name c.measure) (json_number c.rmse)
    (json_number c.mae) (json_number c.max) (json_number c.rel_mse) c.non_finite
    (String.concat "" (List.map more also))
