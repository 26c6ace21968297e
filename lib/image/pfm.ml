open Candor_colour

let ( let* ) = Result.bind

let encode p =
  let width = Picture.width p and height = Picture.height p in
  let out = Buffer.create (40 + (12 * width * height)) in
  let put x = Buffer.add_int32_le out (Int32.bits_of_float x) in
  Printf.bprintf out "PF\n%d %d\n-1.0\n" width height;
  for y = height - 1 downto 0 do
    for x = 0 to width - 1 do
      let { Rgb.r; g; b } = Picture.pixel p x y in
      put r;
      put g;
      put b
    done
  done;
  Buffer.contents out

let scale scan =
  let word = Scan.word scan in
  match float_of_string_opt word with
  | Some s when Float.is_finite s && s <> 0. -> Ok s
  | Some _ | None ->
      Error
        (Printf.sprintf
           "expected the scale, a finite number that is not 0, found %S" word)

let picture file ~start ~width ~height ~channels ~scale =
  let get = if scale < 0. then String.get_int32_le else String.get_int32_be in
  let factor = Float.abs scale in
  let row y =
    let first = start + (4 * channels * width * (height - 1 - y)) in
    Float.Array.init (3 * width) (fun i ->
        let sample = if channels = 3 then i else i / 3 in
        factor *. Int32.float_of_bits (get file (first + (4 * sample))))
  in
  Picture.of_rows ~width (Array.init height row)

let decode file =
  let scan = Scan.v file in
  let* channels =
    match Scan.word scan with
    | "PF" -> Ok 3
    | "Pf" -> Ok 1
    | _ -> Error "this is not a PFM: it does not begin with PF or Pf"
  in
  let* width = Scan.number scan "the width" in
  let* height = Scan.number scan "the height" in
  let* () = Extent.check ~width ~height in
  let* scale = scale scan in
  let* start = Scan.body scan ~bytes:(4 * channels * width * height) in
  Ok (picture file ~start ~width ~height ~channels ~scale)
