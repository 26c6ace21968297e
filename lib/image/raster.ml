open Candor_colour

(* Two bytes a sample: a fourth of what an int array would take. *)
type t = { width : int; height : int; maxval : int; samples : Bytes.t }

let outside value maxval =
  Printf.sprintf "a sample is %d, outside 0 .. %d" value maxval

let init ~width ~height ~maxval f =
  if width < 1 || height < 1 || maxval < 1 || maxval > 0xffff then
    invalid_arg "Raster.init: empty, or a maxval outside 1 .. 65535";
  let count = 3 * width * height in
  let samples = Bytes.create (2 * count) in
  let rec fill i =
    if i = count then Ok { width; height; maxval; samples }
    else
      match f (i / 3 mod width) (i / (3 * width)) (i mod 3) with
      | Error e -> Error e
      | Ok v when v < 0 || v > maxval -> Error (outside v maxval)
      | Ok v ->
          Bytes.set_uint16_ne samples (2 * i) v;
          fill (i + 1)
  in
  fill 0

let of_picture p =
  let width = Picture.width p and height = Picture.height p in
  let samples = Bytes.create (6 * width * height) in
  let set i x = Bytes.set_uint16_ne samples (2 * i) (Display.level x) in
  for y = 0 to height - 1 do
    for x = 0 to width - 1 do
      let { Rgb.r; g; b } = Picture.pixel p x y in
      let i = 3 * ((y * width) + x) in
      set i r;
      set (i + 1) g;
      set (i + 2) b
    done
  done;
  { width; height; maxval = 255; samples }

let width r = r.width
let height r = r.height
let maxval r = r.maxval

let sample r x y c =
  if x < 0 || x >= r.width || y < 0 || y >= r.height || c < 0 || c > 2 then
    invalid_arg "Raster.sample: outside";
  Bytes.get_uint16_ne r.samples (2 * ((3 * ((y * r.width) + x)) + c))

let equal a b =
  a.width = b.width && a.height = b.height && a.maxval = b.maxval
  && Bytes.equal a.samples b.samples
