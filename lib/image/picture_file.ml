type format = Ppm | Png | Pfm [@@deriving show, eq]
type content = Display of Raster.t | Linear of Picture.t

let format_of_name name =
  match String.lowercase_ascii (Filename.extension name) with
  | ".ppm" -> Ok Ppm
  | ".png" -> Ok Png
  | ".pfm" -> Ok Pfm
  | "" ->
      Error
        (Printf.sprintf "%S has no extension: expected .ppm, .png or .pfm" name)
  | other ->
      Error
        (Printf.sprintf "unknown extension %S: expected .ppm, .png or .pfm"
           other)

let encode format ~binary p =
  match format with
  | Ppm -> if binary then Ppm.encode_p6 p else Ppm.encode_p3 p
  | Png -> Png.encode p
  | Pfm -> Pfm.encode p

let unknown file =
  Printf.sprintf
    "expected a picture, PPM (P3 or P6), PNG or PFM (PF or Pf); found a file \
     that begins with %S"
    (String.sub file 0 (min 8 (String.length file)))

let decode file =
  let starts prefix = String.starts_with ~prefix file in
  let display = Result.map (fun raster -> Display raster) in
  if starts "P3" || starts "P6" then display (Ppm.decode file)
  else if starts "\137PNG" then display (Png.decode file)
  else if starts "PF" || starts "Pf" then
    Result.map (fun picture -> Linear picture) (Pfm.decode file)
  else Error (unknown file)
