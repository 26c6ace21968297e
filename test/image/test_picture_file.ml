open Candor_image
open Support

let format = Alcotest.testable Picture_file.pp_format Picture_file.equal_format
let grey = picture_of ~width:1 ~height:1 [| 0.5; 0.5; 0.5 |]

let names () =
  let check name expected =
    Alcotest.(check (result format string))
      name expected
      (Picture_file.format_of_name name)
  in
  check "a.ppm" (Ok Ppm);
  check "dir.x/A.PNG" (Ok Png);
  check "a.b.Pfm" (Ok Pfm);
  check "a.jpg"
    (Error "unknown extension \".jpg\": expected .ppm, .png or .pfm");
  check "a" (Error "\"a\" has no extension: expected .ppm, .png or .pfm")

let starts format binary prefix =
  let file = Picture_file.encode format ~binary grey in
  Alcotest.(check bool) prefix true (String.starts_with ~prefix file)

let written () =
  starts Ppm false "P3\n";
  starts Ppm true "P6\n";
  starts Png false "\137PNG";
  starts Pfm false "PF\n"

let unknown () =
  let check file found =
    match Picture_file.decode file with
    | Ok _ -> Alcotest.failf "accepted %S" file
    | Error message ->
        Alcotest.(check string)
          file
          ("expected a picture, PPM (P3 or P6), PNG or PFM (PF or Pf); found a \
            file that begins with " ^ found)
          message
  in
  check "" {|""|};
  check "GIF89a and more" {|"GIF89a a"|};
  check "P5\n1 1\n" {|"P5\n1 1\n"|}

let told_apart (fmt, binary, p) =
  match (fmt, Picture_file.decode (Picture_file.encode fmt ~binary p)) with
  | (Picture_file.Ppm | Png), Ok (Display r) ->
      Raster.equal r (Raster.of_picture p)
  | Pfm, Ok (Linear q) -> Picture.width q = Picture.width p
  | (Ppm | Png), Ok (Linear _) | Pfm, Ok (Display _) | _, Error _ -> false

let any_format = pick [ Picture_file.Ppm; Png; Pfm ]

let tests =
  [
    unit "an extension names a format, in either case" names;
    unit "binary chooses between the two kinds of PPM" written;
    unit "an unknown file is an error that names what was expected" unknown;
    law "the format is told from the first bytes"
      QCheck2.Gen.(triple any_format bool picture)
      told_apart;
    law "no string of bytes raises" ~count:2000 ~print:String.escaped
      QCheck2.Gen.(
        map2 ( ^ )
          (pick [ "P3"; "P6 "; "\137PNG\r\n\026\n"; "PF "; "Pf "; "" ])
          (string_size (int_bound 60)))
      (survives Picture_file.decode);
  ]

let suite = ("picture file", tests)
