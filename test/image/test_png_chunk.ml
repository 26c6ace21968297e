open Candor_image_hidden
open Support
open QCheck2

let show chunks =
  let one { Png_chunk.kind; data } = Printf.sprintf "%s %S" kind data in
  String.concat "; " (List.map one chunks)

let chunks = Alcotest.testable (Fmt.of_to_string show) ( = )
let read_as = Alcotest.(result chunks string)
let iend = { Png_chunk.kind = "IEND"; data = "" }

let kind =
  let open Gen in
  let letter = oneof [ char_range 'a' 'z'; char_range 'A' 'Z' ] in
  let+ kind = string_size ~gen:letter (pure 4) in
  if kind = "IEND" then "IDAT" else kind

let some =
  let open Gen in
  let chunk =
    let+ kind = kind and+ data = string_size (int_bound 300) in
    { Png_chunk.kind; data }
  in
  let+ first = list_size (int_bound 5) chunk in
  first @ [ iend ]

let there_and_back =
  law "chunks up to an IEND are read as they were written" ~print:show some
    (fun c -> Png_chunk.(read (write c)) = Ok c)

let standard =
  law "chunks are written as the standard says" ~print:show some (fun c ->
      Png_chunk.write c
      = Made_png.file
          (List.map
             (fun { Png_chunk.kind; data } -> Made_png.chunk kind data)
             c))

let cut =
  law "a file that was cut short is an error"
    ~print:Print.(pair show float)
    Gen.(pair some (float_bound_exclusive 1.))
    (fun (c, part) ->
      let file = Png_chunk.write c in
      let kept = int_of_float (part *. float_of_int (String.length file)) in
      Result.is_error (Png_chunk.read (String.sub file 0 kept)))

let flipped =
  law "a file with a wrong bit is an error" ~count:1000
    ~print:Print.(triple show float int)
    Gen.(triple some (float_bound_exclusive 1.) (int_bound 7))
    (fun (c, part, bit) ->
      let file = Bytes.of_string (Png_chunk.write c) in
      let at = int_of_float (part *. float_of_int (Bytes.length file)) in
      Bytes.set_uint8 file at (Bytes.get_uint8 file at lxor (1 lsl bit));
      Result.is_error (Png_chunk.read (Bytes.to_string file)))

let check name expected file =
  Alcotest.check read_as name expected (Png_chunk.read file)

let behind () =
  let file = Png_chunk.write [ iend ] in
  check "bytes" (Ok [ iend ]) (file ^ "more");
  check "a chunk" (Ok [ iend ]) (file ^ Made_png.chunk "IDAT" "x");
  check "an IEND with data"
    (Ok [ { iend with data = "x" } ])
    (Made_png.file [ Made_png.chunk "IEND" "x" ])

let errors () =
  let no_png = Error "this is not a PNG: its signature is missing or damaged" in
  let early = Error "the PNG file ends early" in
  check "nothing" no_png "";
  check "a signature with one line end changed" no_png
    ("\137PNG\n\026\n" ^ Made_png.chunk "IEND" "");
  check "only a signature" early Made_png.signature;
  check "no IEND" early (Made_png.file [ Made_png.chunk "IDAT" "x" ]);
  check "a length above 2^31" early
    (Made_png.file [ "\255\255\255\255IDATxxxx" ]);
  check "a wrong checksum"
    (Error "the checksum of chunk \"IDAT\" is wrong: the PNG is damaged")
    (Made_png.file [ "\000\000\000\001IDATx\000\000\000\000" ])

let suite =
  ( "png chunks",
    [
      there_and_back;
      standard;
      cut;
      flipped;
      unit "what is behind the first IEND is left aside" behind;
      unit "what is wrong with a file is said" errors;
    ] )
