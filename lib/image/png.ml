let ( let* ) = Result.bind

type colour = Grey | Rgb | Palette | Grey_alpha | Rgba
type header = { width : int; height : int; depth : int; colour : colour }

let channels = function
  | Grey | Palette -> 1
  | Grey_alpha -> 2
  | Rgb -> 3
  | Rgba -> 4

let bits_per_pixel h = h.depth * channels h.colour
let stride h = Int.max 1 (bits_per_pixel h / 8)
let row_bytes h = ((h.width * bits_per_pixel h) + 7) / 8

(* Encoding *)

let big_endian n =
  let b = Bytes.create 4 in
  Bytes.set_int32_be b 0 (Int32.of_int n);
  Bytes.to_string b

(* Depth 8, colour type 2 (RGB), deflate, adaptive filters, not interlaced. *)
let header_data ~width ~height =
  big_endian width ^ big_endian height ^ "\008\002\000\000\000"

let gamma = big_endian 45455 (* 100000 / 2.2 *)

let filtered raster =
  let width = Raster.width raster and height = Raster.height raster in
  let out = Buffer.create ((1 + (3 * width)) * height) in
  let sample y i = Char.chr (Raster.sample raster (i / 3) y (i mod 3)) in
  let above = ref (Bytes.make (3 * width) '\000') in
  for y = 0 to height - 1 do
    let row = Bytes.init (3 * width) (sample y) in
    Buffer.add_string out (Png_filter.encode ~stride:3 ~above:!above row);
    above := row
  done;
  Buffer.contents out

let encode p =
  let width = Picture.width p and height = Picture.height p in
  let chunk kind data = { Png_chunk.kind; data } in
  Png_chunk.write
    [
      chunk "IHDR" (header_data ~width ~height);
      chunk "gAMA" gamma;
      chunk "IDAT" (Deflate.pack (filtered (Raster.of_picture p)));
      chunk "IEND" "";
    ]

(* Decoding *)

let colour_of_type = function
  | 0 -> Ok (Grey, [ 1; 2; 4; 8; 16 ])
  | 2 -> Ok (Rgb, [ 8; 16 ])
  | 3 -> Ok (Palette, [ 1; 2; 4; 8 ])
  | 4 -> Ok (Grey_alpha, [ 8; 16 ])
  | 6 -> Ok (Rgba, [ 8; 16 ])
  | n -> Error (Printf.sprintf "%d is not a colour type of PNG" n)

let check_methods data =
  if data.[10] <> '\000' || data.[11] <> '\000' then
    Error "unknown PNG compression or filter method"
  else
    match data.[12] with
    | '\000' -> Ok ()
    | '\001' ->
        Error "interlaced PNG is not supported; save it without interlacing"
    | _ -> Error "unknown PNG interlace method"

let header data =
  if String.length data <> 13 then Error "the PNG header is not 13 bytes long"
  else
    let side at = Int32.to_int (String.get_int32_be data at) land 0xffffffff in
    let width = side 0
    and height = side 4
    and depth = String.get_uint8 data 8 in
    let* () = Extent.check ~width ~height in
    let* colour, depths = colour_of_type (String.get_uint8 data 9) in
    let* () = check_methods data in
    if List.mem depth depths then Ok { width; height; depth; colour }
    else
      Error (Printf.sprintf "%d bits do not go with this PNG colour type" depth)

let unfilter h data =
  let length = row_bytes h and stride = stride h in
  let rows = Array.make h.height Bytes.empty in
  let rec go y above =
    if y = h.height then Ok rows
    else
      let* row = Png_filter.decode ~stride ~above data (y * (length + 1)) in
      rows.(y) <- row;
      go (y + 1) row
  in
  go 0 (Bytes.make length '\000')

let sample ~depth row i =
  match depth with
  | 16 -> Bytes.get_uint16_be row (2 * i)
  | 8 -> Bytes.get_uint8 row i
  | _ ->
      let bit = i * depth in
      let shift = 8 - depth - (bit land 7) in
      (Bytes.get_uint8 row (bit lsr 3) lsr shift) land ((1 lsl depth) - 1)

let look_up palette index c =
  let at = (3 * index) + c in
  if at < String.length palette then Ok (String.get_uint8 palette at)
  else Error (Printf.sprintf "the PNG palette has no colour %d" index)

let raster h ~palette rows =
  let { width; height; depth; colour } = h in
  let direct = Raster.init ~width ~height ~maxval:((1 lsl depth) - 1) in
  let get x y i = sample ~depth rows.(y) ((x * channels colour) + i) in
  match colour with
  | Grey | Grey_alpha -> direct (fun x y _ -> Ok (get x y 0))
  | Rgb | Rgba -> direct (fun x y c -> Ok (get x y c))
  | Palette ->
      Raster.init ~width ~height ~maxval:255 (fun x y c ->
          look_up palette (get x y 0) c)

let data_of kind chunks =
  let only (c : Png_chunk.t) = if c.kind = kind then Some c.data else None in
  String.concat "" (List.filter_map only chunks)

let known (c : Png_chunk.t) =
  match c.kind with
  | "IHDR" | "PLTE" | "IDAT" | "IEND" -> true
  | kind -> Char.lowercase_ascii kind.[0] = kind.[0]

let decode file =
  let* chunks = Png_chunk.read file in
  match (chunks, List.find_opt (Fun.negate known) chunks) with
  | _, Some c -> Error (Printf.sprintf "unknown kind of PNG chunk: %S" c.kind)
  | { kind = "IHDR"; data } :: rest, None ->
      let* h = header data in
      let bytes = h.height * (1 + row_bytes h) in
      let* unpacked = Deflate.unpack ~bytes (data_of "IDAT" rest) in
      let* rows = unfilter h unpacked in
      raster h ~palette:(data_of "PLTE" rest) rows
  | _, None -> Error "a PNG must begin with its header, IHDR"
