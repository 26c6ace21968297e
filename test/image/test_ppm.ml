open Candor_image
open Support

let one_pixel = raster_of ~width:1 ~height:1 ~maxval:255 [| 1; 2; 3 |]

let accepts name expected file =
  Alcotest.check decoded name (Ok expected) (Ppm.decode file)

let rejects message file =
  Alcotest.check decoded (String.escaped file) (Error message) (Ppm.decode file)

let golden () =
  let p = picture_of ~width:2 ~height:1 [| 0.; 0.5; 1.; 2.; 0.001; nan |] in
  Alcotest.(check string)
    "P3" "P3\n2 1\n255\n0 186 255 255 11 0 " (Ppm.encode_p3 p);
  Alcotest.(check string)
    "P6" "P6\n2 1\n255\n\000\186\255\255\011\000" (Ppm.encode_p6 p)

let odd_headers () =
  accepts "comments" one_pixel "P3 # a\n#b 7\n1#c\n 1 # d\n255 1 2#e\n3";
  accepts "blanks" one_pixel "P3\t1\r\n1\011255\012\n1 2 3";
  accepts "leading zeros" one_pixel "P3 01 1 0255 1 002 3 ";
  accepts "a comment before the bytes" one_pixel "P6 1 1 255#x\n\001\002\003";
  accepts "more bytes than pixels" one_pixel "P6 1 1 255\n\001\002\003\004";
  accepts "blanks and hashes among the bytes"
    (raster_of ~width:1 ~height:1 ~maxval:255 [| 10; 35; 32 |])
    "P6 1 1 255\n\n# "

let depths () =
  accepts "maxval 1"
    (raster_of ~width:1 ~height:1 ~maxval:1 [| 0; 1; 0 |])
    "P3 1 1 1 0 1 0";
  accepts "maxval 65535, plain"
    (raster_of ~width:1 ~height:1 ~maxval:65535 [| 0; 65535; 256 |])
    "P3 1 1 65535 0 65535 256";
  accepts "maxval 256: two bytes, the high one first"
    (raster_of ~width:1 ~height:1 ~maxval:256 [| 256; 1; 2 |])
    "P6 1 1 256\n\001\000\000\001\000\002"

let errors () =
  rejects "this is not a PPM: it does not begin with P3 or P6" "P5 1 1 255 a";
  rejects "the file ends where the height is expected" "P3 1";
  rejects "expected the width, found \"-1\"" "P3 -1 1 255 0 0 0";
  rejects "expected the width, found \"0x1\"" "P3 0x1 1 255 0 0 0";
  rejects "a picture of 0 x 1 pixels has no pixel" "P3 0 1 255 ";
  rejects "the largest value is 0, not in 1 .. 65535" "P3 1 1 0 0 0 0";
  rejects "the largest value is 65536, not in 1 .. 65535" "P3 1 1 65536 0 0 0";
  rejects "a sample is 8, outside 0 .. 7" "P3 1 1 7 0 8 0";
  rejects "a sample is 9, outside 0 .. 7" "P6 1 1 7\n\001\009\001";
  rejects "expected a sample, found \"x\"" "P3 1 1 7 0 0 x";
  rejects "the file ends where a sample is expected" "P3 1 1 7 000 0";
  rejects "the file ends early: its pixels need 3 more bytes, 2 are there"
    "P6 1 1 7\n\001\001"

let huge () =
  rejects "99999 x 99999 pixels are too many: the most is 268435456"
    "P6 99999 99999 255\nabc";
  rejects
    "the file ends early: its pixels need 1610612736 more bytes, 6 are there"
    "P3 16384 16384 255 0 0 0";
  rejects "expected the height, found \"1000000000\"" "P3 1 1000000000 255 0"

let round_trip encode p =
  same_decoded (Ppm.decode (encode p)) (Ok (Raster.of_picture p))

let damaged encode = QCheck2.Gen.(picture >>= fun p -> damage (encode p))

let tests =
  [
    unit "a 2x1 picture is written as smallpt would, to the byte" golden;
    unit "comments and odd blanks are read" odd_headers;
    unit "largest values from 1 to 65535 are read" depths;
    unit "what is wrong is said" errors;
    unit "a short file that declares a huge picture is an error at once" huge;
    law "P3 reads back as what is displayed" ~print:show_picture picture
      (round_trip Ppm.encode_p3);
    law "P6 reads back as what is displayed" ~print:show_picture picture
      (round_trip Ppm.encode_p6);
    law "a damaged P3 never raises" ~count:2000 ~print:String.escaped
      (damaged Ppm.encode_p3) (survives Ppm.decode);
    law "a damaged P6 never raises" ~count:2000 ~print:String.escaped
      (damaged Ppm.encode_p6) (survives Ppm.decode);
  ]

let suite = ("ppm", tests)
