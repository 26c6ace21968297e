open Candor_colour
open Candor_image
open Candor_scene

let ( let* ) = Result.bind

(* sRGB's transfer function, from [0;1] to [0;1]. *)
let linear c =
  if c <= 0.04045 then c /. 12.92
  else if c >= 1. then 1.
  else ((c +. 0.055) /. 1.055) ** 2.4

let of_raster raster =
  let maxval = Raster.maxval raster in
  let levels =
    Float.Array.init (maxval + 1) (fun n ->
        linear (float_of_int n /. float_of_int maxval))
  in
  let at x y c = Float.Array.get levels (Raster.sample raster x y c) in
  Texels.init ~width:(Raster.width raster) ~height:(Raster.height raster)
    (fun x y -> Rgb.v (at x y 0) (at x y 1) (at x y 2))

let of_picture p =
  Texels.init ~width:(Picture.width p) ~height:(Picture.height p)
    (Picture.pixel p)

let of_content = function
  | Picture_file.Display raster -> of_raster raster
  | Linear picture -> of_picture picture

let most = 65536

let check_size texels =
  let width = Texels.width texels and height = Texels.height texels in
  if width <= most && height <= most then Ok ()
  else
    Error
      (Printf.sprintf "%d x %d pixels are too many: the most is %d each way"
         width height most)

(* Whether a component is outside; [nan] is. *)
let outside limit { Rgb.r; g; b } =
  let within x = x >= 0. && x <= limit in
  not (within r && within g && within b)

let first p texels =
  let width = Texels.width texels in
  let rec from i =
    let x = i mod width and y = i / width in
    if y = Texels.height texels then None
    else if p (Texels.get texels x y) then Some (x, y)
    else from (i + 1)
  in
  from 0

let check_values limit demand texels =
  match first (outside limit) texels with
  | None -> Ok ()
  | Some (x, y) ->
      let { Rgb.r; g; b } = Texels.get texels x y in
      Error
        (Printf.sprintf "the pixel in column %d, row %d is (rgb %g %g %g): %s" x
           y r g b demand)

let load_within limit demand path =
  let* (_ : Picture_file.format) = Picture_file.format_of_name path in
  let* file = Contents.of_file ~what:"a picture" path in
  let* content = Picture_file.decode file in
  let texels = of_content content in
  let* () = check_size texels in
  let* () = check_values limit demand texels in
  Ok texels

let load = load_within Float.max_float "light must be finite and not negative"
let load_reflectance = load_within 1. "a reflecting colour must be in [0;1]"
