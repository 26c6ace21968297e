open Candor_colour

type t = { width : int; rows : floatarray array }

let of_rows ~width rows =
  let fits row = Float.Array.length row = 3 * width in
  if width < 1 || Array.length rows = 0 || not (Array.for_all fits rows) then
    invalid_arg "Picture.of_rows: rows must be 3 * width numbers each";
  { width; rows }

let init ~width ~height f =
  if width < 1 || height < 1 then
    invalid_arg "Picture.init: a picture has at least one pixel";
  let row y =
    let row = Float.Array.create (3 * width) in
    for x = 0 to width - 1 do
      let { Rgb.r; g; b } = f x y in
      Float.Array.set row (3 * x) r;
      Float.Array.set row ((3 * x) + 1) g;
      Float.Array.set row ((3 * x) + 2) b
    done;
    row
  in
  { width; rows = Array.init height row }

let width p = p.width
let height p = Array.length p.rows

let pixel p x y =
  let at i = Float.Array.get p.rows.(y) ((3 * x) + i) in
  if x < 0 || x >= p.width then invalid_arg "Picture.pixel: outside";
  Rgb.v (at 0) (at 1) (at 2)

let equal a b =
  let same x y = Int64.equal (Int64.bits_of_float x) (Int64.bits_of_float y) in
  let same_row r s =
    let rec go i =
      i = Float.Array.length r
      || (same (Float.Array.get r i) (Float.Array.get s i) && go (i + 1))
    in
    go 0
  in
  a.width = b.width
  && height a = height b
  && Array.for_all2 same_row a.rows b.rows
