open Candor_image
open Support

let round32 x = Int32.float_of_bits (Int32.bits_of_float x)

let rounded p =
  Picture.init ~width:(Picture.width p) ~height:(Picture.height p) (fun x y ->
      let { Candor_colour.Rgb.r; g; b } = Picture.pixel p x y in
      Candor_colour.Rgb.v (round32 r) (round32 g) (round32 b))

let same a b = Result.equal ~ok:Picture.equal ~error:String.equal a b

let accepts name expected file =
  Alcotest.(check bool) name true (same (Ok expected) (Pfm.decode file))

let rejects expected file =
  match Pfm.decode file with
  | Ok _ -> Alcotest.failf "accepted %S" file
  | Error message -> Alcotest.(check string) "message" expected message

let golden () =
  let p = picture_of ~width:1 ~height:2 [| 1.; 2.; -0.; 0.5; nan; 1e40 |] in
  Alcotest.(check string)
    "the bottom row comes first, the low byte first"
    "PF\n\
     1 2\n\
     -1.0\n\
     \x00\x00\x00\x3f\x00\x00\xc0\x7f\x00\x00\x80\x7f\x00\x00\x80\x3f\x00\x00\x00\x40\x00\x00\x00\x80"
    (Pfm.encode p)

let big_endian () =
  accepts "big-endian"
    (picture_of ~width:1 ~height:1 [| 1.; 2.; 0.5 |])
    "PF 1 1 1\n\x3f\x80\x00\x00\x40\x00\x00\x00\x3f\x00\x00\x00"

let grey () =
  accepts "grey"
    (picture_of ~width:1 ~height:2 [| 2.; 2.; 2.; 1.; 1.; 1. |])
    "Pf\n1 2\n1.0\n\x3f\x80\x00\x00\x40\x00\x00\x00"

let scaled () =
  accepts "scale 2, little-endian"
    (picture_of ~width:1 ~height:1 [| 2.; 2.; 2. |])
    "Pf\n1 1\n-2.0\n\x00\x00\x80\x3f"

let errors () =
  let not_pfm = "this is not a PFM: it does not begin with PF or Pf" in
  rejects not_pfm "";
  rejects not_pfm "PG 1 1 1 ";
  let scale =
    Printf.sprintf "expected the scale, a finite number that is not 0, found %S"
  in
  List.iter
    (fun word -> rejects (scale word) (Printf.sprintf "Pf 1 1 %s\nabcd" word))
    [ "0"; "-0.0"; "nan"; "inf"; "1e999"; "big" ];
  rejects (scale "") "Pf 1 1";
  rejects "the file ends early: its pixels need 4 more bytes, 3 are there"
    "Pf 1 1 1\nabc";
  rejects
    "the file ends early: its pixels need 1073741824 more bytes, 3 are there"
    "Pf 16384 16384 1\nabc"

let tests =
  [
    unit "a 1x2 picture is written to the byte" golden;
    unit "a positive scale means big-endian" big_endian;
    unit "grey files are read, bottom row first" grey;
    unit "samples are multiplied by the scale" scaled;
    unit "what is wrong is said" errors;
    law "reading what was written rounds to single precision, bit for bit"
      ~count:1000 ~print:show_picture picture (fun p ->
        same (Pfm.decode (Pfm.encode p)) (Ok (rounded p)));
    law "a damaged PFM never raises" ~count:2000 ~print:String.escaped
      QCheck2.Gen.(picture >>= fun p -> damage (Pfm.encode p))
      (survives Pfm.decode);
  ]

let suite = ("pfm", tests)
