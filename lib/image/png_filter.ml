type t = Plain | Sub | Up | Average | Paeth

let all = [ Plain; Sub; Up; Average; Paeth ]

let to_byte = function
  | Plain -> 0
  | Sub -> 1
  | Up -> 2
  | Average -> 3
  | Paeth -> 4

let of_byte b = List.find_opt (fun filter -> to_byte filter = b) all

let paeth ~left ~up ~corner =
  let guess = left + up - corner in
  let off_left = abs (guess - left)
  and off_up = abs (guess - up)
  and off_corner = abs (guess - corner) in
  if off_left <= off_up && off_left <= off_corner then left
  else if off_up <= off_corner then up
  else corner

let predict filter ~stride ~above row i =
  let left = if i < stride then 0 else Bytes.get_uint8 row (i - stride) in
  let up = Bytes.get_uint8 above i in
  match filter with
  | Plain -> 0
  | Sub -> left
  | Up -> up
  | Average -> (left + up) / 2
  | Paeth ->
      let corner =
        if i < stride then 0 else Bytes.get_uint8 above (i - stride)
      in
      paeth ~left ~up ~corner

let apply ~stride ~above row filter =
  let out = Bytes.create (1 + Bytes.length row) in
  Bytes.set_uint8 out 0 (to_byte filter);
  let cost = ref 0 in
  for i = 0 to Bytes.length row - 1 do
    let guess = predict filter ~stride ~above row i in
    let residue = (Bytes.get_uint8 row i - guess) land 255 in
    Bytes.set_uint8 out (i + 1) residue;
    cost := !cost + Int.min residue (256 - residue)
  done;
  (!cost, Bytes.unsafe_to_string out)

let encode ~stride ~above row =
  let cheaper (a, x) (b, y) = if (b : int) < a then (b, y) else (a, x) in
  let plain = apply ~stride ~above row Plain in
  [ Sub; Up; Average; Paeth ]
  |> List.map (apply ~stride ~above row)
  |> List.fold_left cheaper plain
  |> snd

let undo filter ~stride ~above data at =
  let row = Bytes.sub data (at + 1) (Bytes.length above) in
  for i = 0 to Bytes.length row - 1 do
    let guess = predict filter ~stride ~above row i in
    Bytes.set_uint8 row i ((Bytes.get_uint8 row i + guess) land 255)
  done;
  row

let decode ~stride ~above data at =
  let byte = Bytes.get_uint8 data at in
  match of_byte byte with
  | Some filter -> Ok (undo filter ~stride ~above data at)
  | None -> Error (Printf.sprintf "%d is not a row filter of PNG" byte)
