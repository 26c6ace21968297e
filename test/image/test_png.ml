open Candor_image
open Support
open QCheck2

(* A file of any colour type and depth, and the raster it should read as. *)

type made = {
  width : int;
  height : int;
  depth : int;
  colour : int;
  filters : int array;
  palette : int array;
  samples : int array array;
}

let kinds =
  [ (0, 1); (0, 2); (0, 4); (0, 8); (0, 16); (2, 8); (2, 16); (3, 1); (3, 2) ]
  @ [ (3, 4); (3, 8); (4, 8); (4, 16); (6, 8); (6, 16) ]

let made_of (colour, depth) filter =
  let open Gen in
  let* width = int_range 1 11 in
  let* height = int_range 1 5 in
  let* filters = array_size (pure height) filter in
  let* palette = array_size (pure 768) (int_bound 255) in
  let length = width * Made_png.channels colour in
  let row = array_size (pure length) (int_bound ((1 lsl depth) - 1)) in
  let+ samples = array_size (pure height) row in
  { width; height; depth; colour; filters; palette; samples }

let any_filter = Gen.int_bound 4
let made = Gen.(pick kinds >>= fun kind -> made_of kind any_filter)

let palette_data m =
  String.init (min 768 (3 lsl m.depth)) (fun i -> Char.chr m.palette.(i))

let file_of ?(spoil = Fun.id) m =
  let { width; height; depth; colour; filters; samples; _ } = m in
  let data = Made_png.rows ~depth ~colour ~filters samples in
  let half = String.length data / 2 in
  let packed = Made_png.zlib data in
  Made_png.(
    file
      ([ header ~width ~height ~depth ~colour () ]
      @ (if colour = 3 then [ chunk "PLTE" (palette_data m) ] else [])
      @ [
          chunk "tEXt" "ignored";
          chunk "IDAT" (spoil (String.sub packed 0 half));
          chunk "IDAT"
            (spoil (String.sub packed half (String.length packed - half)));
          chunk "IEND" "";
        ]))

let raster_of_made m =
  let sample x y c =
    let at i = m.samples.(y).((x * Made_png.channels m.colour) + i) in
    match m.colour with
    | 0 | 4 -> at 0
    | 3 -> m.palette.((3 * at 0) + c)
    | _ -> at c
  in
  let maxval = if m.colour = 3 then 255 else (1 lsl m.depth) - 1 in
  raster_of ~width:m.width ~height:m.height ~maxval
    (Array.init
       (3 * m.width * m.height)
       (fun i -> sample (i / 3 mod m.width) (i / 3 / m.width) (i mod 3)))

let reads_as_made m =
  same_decoded (Png.decode (file_of m)) (Ok (raster_of_made m))

let show_made m =
  Printf.sprintf "colour type %d, depth %d, %dx%d" m.colour m.depth m.width
    m.height

let every_kind =
  let law_of (colour, depth) =
    let name =
      Printf.sprintf "colour type %d at depth %d is read" colour depth
    in
    law name ~count:50 ~print:show_made
      (made_of (colour, depth) any_filter)
      reads_as_made
  in
  List.map law_of kinds

let every_filter =
  let law_of kind name =
    law
      (Printf.sprintf "rows filtered by %s are read" name)
      ~count:100 ~print:show_made
      Gen.(pick kinds >>= fun k -> made_of k (pure kind))
      reads_as_made
  in
  List.mapi law_of [ "None"; "Sub"; "Up"; "Average"; "Paeth" ]

(* Errors *)

let rejects message file =
  Alcotest.check decoded message (Error message) (Png.decode file)

let grey_header = Made_png.header ~width:1 ~height:1 ~depth:8 ~colour:0
let data raw = Made_png.(chunk "IDAT" (zlib raw))
let iend = Made_png.chunk "IEND" ""
let small = [ grey_header (); data "\000\007"; iend ]

let odd_files () =
  let grey = raster_of ~width:1 ~height:1 ~maxval:255 [| 7; 7; 7 |] in
  let accepts name file =
    Alcotest.check decoded name (Ok grey) (Png.decode file)
  in
  accepts "a small file" (Made_png.file small);
  accepts "bytes behind the end" (Made_png.file small ^ "more");
  accepts "empty data chunks"
    Made_png.(
      file
        [
          grey_header ();
          chunk "IDAT" "";
          data "\000\007";
          chunk "IDAT" "";
          iend;
        ])

let errors () =
  let open Made_png in
  let header_error message header =
    rejects message (file [ header; data "\000\007"; iend ])
  in
  rejects "this is not a PNG: its signature is missing or damaged"
    "\137PNG\n\026\n";
  rejects "a PNG must begin with its header, IHDR" (file [ iend ]);
  header_error "the PNG header is not 13 bytes long" (chunk "IHDR" "short");
  header_error "interlaced PNG is not supported; save it without interlacing"
    (grey_header ~interlace:1 ());
  header_error "unknown PNG interlace method" (grey_header ~interlace:2 ());
  header_error "a picture of 0 x 1 pixels has no pixel"
    (header ~width:0 ~height:1 ~depth:8 ~colour:0 ());
  header_error "5 is not a colour type of PNG"
    (header ~width:1 ~height:1 ~depth:8 ~colour:5 ());
  header_error "4 bits do not go with this PNG colour type"
    (header ~width:1 ~height:1 ~depth:4 ~colour:2 ());
  header_error "the PNG palette has no colour 7"
    (header ~width:1 ~height:1 ~depth:8 ~colour:3 ());
  rejects "unknown kind of PNG chunk: \"CgBI\""
    (file (grey_header () :: chunk "CgBI" "" :: small))

let damaged_data () =
  let open Made_png in
  let with_data packed = file [ grey_header (); chunk "IDAT" packed; iend ] in
  let raw = "\000\007" in
  let short = "the compressed data end early" in
  rejects "5 is not a row filter of PNG" (with_data (zlib "\005\007"));
  rejects short (with_data (zlib "\000"));
  rejects short (with_data (String.sub (zlib raw) 0 8));
  rejects short (with_data "");
  rejects "the compressed data are damaged" (with_data "not zlib at all");
  rejects "the compressed data are damaged"
    (with_data (String.sub (zlib raw) 0 9 ^ "\000\000\000\000"));
  rejects "the compressed data hold more than the pixels declared"
    (with_data (zlib "\000\007\008"));
  rejects "the PNG file ends early" (file [ grey_header (); data raw ]);
  let right = file small in
  let wrong = Bytes.of_string right in
  Bytes.set wrong 20 '\001';
  rejects "the checksum of chunk \"IHDR\" is wrong: the PNG is damaged"
    (Bytes.to_string wrong)

let bombs () =
  let declared ~width ~height =
    Made_png.(
      file
        [ header ~width ~height ~depth:8 ~colour:2 (); data "\000\007"; iend ])
  in
  rejects "the compressed data end early" (declared ~width:16384 ~height:16384);
  rejects "4294967295 x 4294967295 pixels are too many: the most is 268435456"
    (declared ~width:0xffffffff ~height:0xffffffff)

let spoilt =
  let open Gen in
  let* m = made in
  let* at = int_bound 200 in
  let+ byte = char in
  let spoil s =
    String.mapi (fun i c -> if i = at mod String.length s then byte else c) s
  in
  file_of ~spoil m

(* Encoding *)

let rec find_chunk kind file at =
  let length = Int32.to_int (String.get_int32_be file at) in
  if String.sub file (at + 4) 4 = kind then String.sub file (at + 8) length
  else find_chunk kind file (at + 12 + length)

let chunks_written () =
  let file = Png.encode (picture_of ~width:1 ~height:1 [| 0.; 0.5; 1. |]) in
  let check kind expected =
    Alcotest.(check string) kind expected (find_chunk kind file 8)
  in
  check "IHDR" "\000\000\000\001\000\000\000\001\008\002\000\000\000";
  check "gAMA" "\000\000\177\143";
  check "IEND" ""

let smooth_is_small () =
  let ramp x y = Candor_colour.Rgb.grey (float_of_int (x + y) /. 512.) in
  let file =
    Png.encode (Candor_image.Picture.init ~width:256 ~height:256 ramp)
  in
  Alcotest.(check bool)
    "less than a tenth of the raw size" true
    (String.length file < 3 * 256 * 256 / 10)

let tests =
  [
    unit "one pixel is written with its header and gamma 1/2.2" chunks_written;
    unit "filters make a smooth picture small" smooth_is_small;
    law "PNG reads back as what is displayed" ~print:show_picture picture
      (fun p ->
        same_decoded (Png.decode (Png.encode p)) (Ok (Raster.of_picture p)));
    law "PNG and P3 hold the same numbers" ~print:show_picture picture (fun p ->
        same_decoded (Png.decode (Png.encode p)) (Ppm.decode (Ppm.encode_p3 p)));
  ]
  @ every_kind @ every_filter
  @ [
      unit "unusual but right files are read" odd_files;
      unit "what is wrong in a header is said" errors;
      unit "damaged image data are an error" damaged_data;
      unit "a short file that declares a huge picture is an error at once" bombs;
      law "a cut or changed PNG is an error" ~count:2000
        Gen.(
          let* file = map (fun m -> file_of m) made in
          map (fun bad -> (file, bad)) (damage file))
        (fun (file, bad) -> bad = file || Result.is_error (Png.decode bad));
      law "damage under right checksums never raises" ~count:2000
        ~print:String.escaped spoilt (survives Png.decode);
    ]

let suite = ("png", tests)
