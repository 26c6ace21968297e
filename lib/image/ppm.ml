let ( let* ) = Result.bind

let encode magic put ~bytes_per_pixel p =
  let raster = Raster.of_picture p in
  let width = Raster.width raster and height = Raster.height raster in
  let out = Buffer.create (20 + (bytes_per_pixel * width * height)) in
  Printf.bprintf out "%s\n%d %d\n255\n" magic width height;
  for y = 0 to height - 1 do
    for x = 0 to width - 1 do
      for c = 0 to 2 do
        put out (Raster.sample raster x y c)
      done
    done
  done;
  Buffer.contents out

let words = Array.init 256 (Printf.sprintf "%d ")

let encode_p3 =
  let put out level = Buffer.add_string out words.(level) in
  encode "P3" put ~bytes_per_pixel:12

let encode_p6 = encode "P6" Buffer.add_uint8 ~bytes_per_pixel:3

let plain scan ~width ~height ~maxval =
  (* The shortest sample is a blank and a digit. *)
  let needed = 6 * width * height and left = Scan.left scan in
  if left < needed then Error (Scan.ends_early ~needed ~left)
  else
    Raster.init ~width ~height ~maxval (fun _ _ _ ->
        Scan.number scan "a sample")

let binary file scan ~width ~height ~maxval =
  let size = if maxval < 256 then 1 else 2 in
  let get = if size = 1 then String.get_uint8 else String.get_uint16_be in
  let* start = Scan.body scan ~bytes:(3 * width * height * size) in
  Raster.init ~width ~height ~maxval (fun x y c ->
      Ok (get file (start + (size * ((3 * ((y * width) + x)) + c)))))

let maxval scan =
  let* n = Scan.number scan "the largest value" in
  if n >= 1 && n <= 0xffff then Ok n
  else Error (Printf.sprintf "the largest value is %d, not in 1 .. 65535" n)

let decode file =
  let scan = Scan.v file in
  let* samples =
    match Scan.word scan with
    | "P3" -> Ok plain
    | "P6" -> Ok (binary file)
    | _ -> Error "this is not a PPM: it does not begin with P3 or P6"
  in
  let* width = Scan.number scan "the width" in
  let* height = Scan.number scan "the height" in
  let* () = Extent.check ~width ~height in
  let* maxval = maxval scan in
  samples scan ~width ~height ~maxval
