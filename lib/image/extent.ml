let most_pixels = 1 lsl 28

let check ~width ~height =
  if width < 1 || height < 1 then
    Error
      (Printf.sprintf "a picture of %d x %d pixels has no pixel" width height)
  else if width > most_pixels / height then
    Error
      (Printf.sprintf "%d x %d pixels are too many: the most is %d" width height
         most_pixels)
  else Ok ()
