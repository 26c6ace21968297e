open Candor_image_hidden
open Support
open QCheck2

type case = { stride : int; above : string; row : string }

(* Rows of noise, smooth ones, and ones much like the row above. *)
let case =
  let open Gen in
  let* stride = pick [ 1; 2; 3; 4; 6; 8 ] in
  let* length = int_range 1 40 in
  let noise = string_size (pure length) in
  let* above = noise in
  let* slope = int_bound 255 in
  let ramp = String.init length (fun i -> Char.chr (slope * i land 255)) in
  let* off = int_bound 3 in
  let near = String.map (fun c -> Char.chr ((Char.code c + off) land 255)) in
  let+ row = oneof [ noise; pure ramp; pure (near above) ] in
  { stride; above; row }

let print { stride; above; row } =
  Printf.sprintf "stride %d, %S below %S" stride row above

let encode { stride; above; row } =
  Png_filter.encode ~stride ~above:(Bytes.of_string above) (Bytes.of_string row)

let decode { stride; above; _ } data at =
  Png_filter.decode ~stride ~above:(Bytes.of_string above)
    (Bytes.of_string data) at
  |> Result.map Bytes.to_string

let filtered { stride; above; row } kind =
  Made_png.filter kind ~stride ~above row

let there_and_back =
  law "what is encoded decodes to the same row" ~count:2000 ~print case
    (fun c -> decode c (encode c) 0 = Ok c.row)

let kinds = [ 0; 1; 2; 3; 4 ]

let standard =
  law "every filter is undone as the standard says, anywhere in the data"
    ~count:2000
    ~print:(fun (c, before) -> Printf.sprintf "%s behind %S" (print c) before)
    Gen.(pair case (string_size (int_bound 5)))
    (fun (c, before) ->
      List.for_all
        (fun kind ->
          decode c (before ^ filtered c kind ^ "behind") (String.length before)
          = Ok c.row)
        kinds)

let cost residues =
  let signed c = if Char.code c < 128 then Char.code c else Char.code c - 256 in
  let behind_filter = String.sub residues 1 (String.length residues - 1) in
  String.fold_left (fun sum c -> sum + abs (signed c)) 0 behind_filter

let cheapest =
  law "the filter with the least sum is taken, the first of equals" ~count:2000
    ~print case (fun c ->
      let best (a : string) b = if cost b < cost a then b else a in
      encode c
      = List.fold_left best (filtered c 0) (List.map (filtered c) kinds))

let examples () =
  let check name expected ~above row =
    Alcotest.(check string) name expected (encode { stride = 1; above; row })
  in
  let dark = "\000\000\000\000" in
  check "zeros stay as they are" "\000\000\000\000\000" ~above:dark dark;
  check "a step is less the pixel on its left" "\001\200\000\000\000"
    ~above:dark "\200\200\200\200";
  check "a row like the one above is less that" "\002\000\000\000\000"
    ~above:"\009\120\033\077" "\009\120\033\077"

let unknown () =
  let row byte =
    decode { stride = 1; above = "\000"; row = "" } (String.make 2 byte) 0
  in
  for byte = 5 to 255 do
    Alcotest.(check (result string string))
      (string_of_int byte)
      (Error (Printf.sprintf "%d is not a row filter of PNG" byte))
      (row (Char.chr byte))
  done

let suite =
  ( "png filters",
    [
      there_and_back;
      standard;
      cheapest;
      unit "zeros, steps and equal rows leave nothing" examples;
      unit "there are five filters and no more" unknown;
    ] )
