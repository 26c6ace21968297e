open Candor_colour
open Candor_image
open Candor_image_hidden
open Candor_scene
open Candor_read
open Text

let file name text f = Files.with_folder (fun d -> f (Files.write d name text))

let loaded ?(load = Picture_decoder.load) name text =
  file name text (fun path ->
      match load path with
      | Ok texels -> texels
      | Error why -> Alcotest.failf "%s: %s" name why)

let refused ?(load = Picture_decoder.load) name text expected =
  file name text (fun path ->
      match load path with
      | Ok _ -> Alcotest.failf "%s: loaded" name
      | Error why -> Alcotest.(check string) name expected why)

(* The inverse of what the library does: sRGB from linear light. *)
let encoded x =
  if x <= 0.0031308 then 12.92 *. x else (1.055 *. (x ** (1. /. 2.4))) -. 0.055

let close name ~within expected found =
  if not (Float.abs (found -. expected) <= within) then
    Alcotest.failf "%s: expected %.17g, found %.17g" name expected found

let levels = [| 0; 1; 10; 11; 55; 128; 200; 254; 255 |]

let check_levels name maxval levels texels =
  Alcotest.(check (pair int int))
    (name ^ ", size")
    (Array.length levels, 2)
    (Texels.width texels, Texels.height texels);
  Array.iteri
    (fun x n ->
      let { Rgb.r; g; b } = Texels.get texels x 0 in
      let part k = float_of_int k /. float_of_int maxval in
      close name ~within:1e-7 (part n) (encoded r);
      close name ~within:1e-7 (part (maxval - n)) (encoded g);
      Alcotest.(check (float 0.)) (name ^ ", full") 1. b;
      Alcotest.(check bool)
        (name ^ ", second row") true
        (Rgb.equal Rgb.black (Texels.get texels x 1)))
    levels

(* Red is the level, green what is left of full brightness, blue full; the
   second row is black. *)
let samples maxval levels =
  let first = Array.map (fun n -> [ n; maxval - n; maxval ]) levels in
  let second = Array.map (fun _ -> [ 0; 0; 0 ]) levels in
  List.concat_map (fun row -> List.concat (Array.to_list row)) [ first; second ]

let ppm magic maxval levels body =
  Printf.sprintf "%s\n%d 2\n%d\n%s" magic (Array.length levels) maxval body

let p3 maxval levels =
  samples maxval levels |> List.map string_of_int |> String.concat " "
  |> ppm "P3" maxval levels

let bytes size numbers =
  let byte n i = Char.chr ((n lsr (8 * i)) land 255) in
  let number n = String.init size (fun i -> byte n (size - 1 - i)) in
  String.concat "" (List.map number numbers)

let p6 maxval levels =
  let size = if maxval < 256 then 1 else 2 in
  ppm "P6" maxval levels (bytes size (samples maxval levels))

let png maxval levels =
  let size = if maxval < 256 then 1 else 2 in
  let row = String.length (bytes size (samples maxval levels)) / 2 in
  let all = bytes size (samples maxval levels) in
  let data = "\000" ^ String.sub all 0 row ^ "\000" ^ String.sub all row row in
  let header =
    bytes 4 [ Array.length levels; 2 ] ^ bytes 1 [ 8 * size; 2; 0; 0; 0 ]
  in
  let chunk kind data = { Png_chunk.kind; data } in
  Png_chunk.write
    [ chunk "IHDR" header; chunk "IDAT" (Deflate.pack data); chunk "IEND" "" ]

let deep = [| 0; 1; 257; 2650; 2651; 2652; 30000; 65534; 65535 |]

let whole_numbers () =
  check_levels "P3" 255 levels (loaded "a.ppm" (p3 255 levels));
  check_levels "P6" 255 levels (loaded "a.PPM" (p6 255 levels));
  check_levels "PNG" 255 levels (loaded "a.png" (png 255 levels));
  check_levels "P3 of 16 bits" 65535 deep (loaded "a.ppm" (p3 65535 deep));
  check_levels "P6 of 16 bits" 65535 deep (loaded "a.ppm" (p6 65535 deep));
  check_levels "PNG of 16 bits" 65535 deep (loaded "a.Png" (png 65535 deep));
  check_levels "P6 of 10 bits" 1000 [| 0; 40; 41; 999; 1000 |]
    (loaded "a.ppm" (p6 1000 [| 0; 40; 41; 999; 1000 |]))

(* Values from the standard's formula, to more digits than doubles have. *)
let transfer () =
  let texels =
    loaded "a.ppm" "P3 4 1 255 10 10 10 11 11 11 128 128 128 188 188 188"
  in
  List.iteri
    (fun x expected ->
      close "linear" ~within:1e-15 expected (Texels.get texels x 0).r)
    [
      0.0030352698354883749;
      0.0033465357638991585;
      0.21586050011389918;
      0.50288645803256837;
    ]

let rises () =
  let all = Array.init 65536 Fun.id in
  let texels = loaded "a.ppm" (p6 65535 all) in
  for x = 1 to 65535 do
    let a = Texels.get texels (x - 1) 0 and b = Texels.get texels x 0 in
    if not (a.r < b.r && b.r <= 1.) then Alcotest.failf "level %d" x
  done

let linear = [| 0.; 0.25; 0x1p-149; 0x1p127; 3.5; 1. |]

let picture values =
  Picture.init ~width:(Array.length values) ~height:2 (fun x y ->
      if y = 0 then Rgb.v values.(x) 1. 0.5 else Rgb.grey 0.125)

let check_linear load values =
  let texels = loaded ~load "a.pfm" (Pfm.encode (picture values)) in
  let expected =
    Texels.init ~width:(Array.length values) ~height:2
      (Picture.pixel (picture values))
  in
  Alcotest.(check bool) "the same" true (Texels.equal expected texels)

let floats () =
  check_linear Picture_decoder.load linear;
  check_linear Picture_decoder.load_reflectance [| 0.; 1.; 0.75; 0x1p-149 |]

let bad_values () =
  let pfm x = Pfm.encode (picture [| 0.; x; 0. |]) in
  let refused load name demand x =
    let message =
      Printf.sprintf "the pixel in column 1, row 0 is (rgb %s 1 0.5): %s" name
        demand
    in
    refused ~load "a.pfm" (pfm x) message
  in
  let light = "light must be finite and not negative" in
  refused Picture_decoder.load "-1" light (-1.);
  refused Picture_decoder.load "inf" light infinity;
  refused Picture_decoder.load "nan" light nan;
  let share = "a reflecting colour must be in [0;1]" in
  refused Picture_decoder.load_reflectance "-1" share (-1.);
  refused Picture_decoder.load_reflectance "2" share 2.;
  refused Picture_decoder.load_reflectance "nan" share nan

let encoders () =
  let p = picture [| 0.; 0.5; 1.; 0.1 |] in
  let same name text =
    let texels = loaded ~load:Picture_decoder.load_reflectance name text in
    let raster = Raster.of_picture p in
    for x = 0 to 3 do
      for y = 0 to 1 do
        let n = Raster.sample raster x y 0 in
        close name ~within:1e-7
          (float_of_int n /. 255.)
          (encoded (Texels.get texels x y).r)
      done
    done
  in
  same "a.ppm" (Ppm.encode_p3 p);
  same "a.ppm" (Ppm.encode_p6 p);
  same "a.png" (Png.encode p);
  same "by its contents.png" (Ppm.encode_p6 p)

let wrong_files () =
  refused "a.gif" "P3 1 1 255 0 0 0"
    "unknown extension \".gif\": expected .ppm, .png or .pfm";
  refused "a.png" "GIF89a..."
    "expected a picture, PPM (P3 or P6), PNG or PFM (PF or Pf); found a file \
     that begins with \"GIF89a..\"";
  refused "a.ppm" ""
    "expected a picture, PPM (P3 or P6), PNG or PFM (PF or Pf); found a file \
     that begins with \"\"";
  refused "a.ppm" "P3 65537 1 255"
    "the file ends early: its pixels need 393222 more bytes, 0 are there"

let too_wide () =
  refused "a.ppm"
    ("P6 65537 1 255\n" ^ String.make (3 * 65537) 'a')
    "65537 x 1 pixels are too many: the most is 65536 each way";
  refused "a.ppm"
    ("P6 1 65537 255\n" ^ String.make (3 * 65537) 'a')
    "1 x 65537 pixels are too many: the most is 65536 each way"

let missing () =
  let check path expected =
    match Picture_decoder.load path with
    | Ok _ -> Alcotest.failf "%S: loaded" path
    | Error why -> Alcotest.(check string) path expected why
  in
  check "/nowhere/at/all.png" "there is no such file";
  check "a\000b.png" "there is no such file";
  check "" "\"\" has no extension: expected .ppm, .png or .pfm";
  check (String.make 5000 'a' ^ ".png") "cannot be read: file name too long";
  Files.with_folder (fun folder ->
      let pipe = Filename.concat folder "a.png" in
      Unix.mkfifo pipe 0o600;
      check pipe "this is not a regular file");
  let folder = Filename.temp_dir "candor" ".png" in
  Fun.protect
    ~finally:(fun () -> Sys.rmdir folder)
    (fun () -> check folder "this is a folder, not a picture")

(* Every file cut short, and with each byte changed. *)
let damaged () =
  List.iter
    (fun (name, text) ->
      let survives text =
        file name text (fun path ->
            match Picture_decoder.load path with
            | Ok _ -> ()
            | Error why ->
                if why = "" || String.contains why '\n' then
                  Alcotest.failf "%s: %S" name why)
      in
      String.iteri
        (fun i c ->
          survives (String.sub text 0 i);
          let changed = Bytes.of_string text in
          Bytes.set changed i (Char.chr (Char.code c lxor (1 lsl (i mod 8))));
          survives (Bytes.to_string changed))
        text)
    [
      ("a.ppm", p3 255 [| 7; 9 |]);
      ("a.ppm", p6 65535 [| 7; 9 |]);
      ("a.png", png 65535 [| 7; 9 |]);
      ("a.pfm", Pfm.encode (picture [| 0.; 1. |]));
    ]

let suite =
  ( "picture decoder",
    [
      case "PNG and PPM of up to 16 bits are sRGB" whole_numbers;
      case "sRGB is decoded to 15 digits" transfer;
      case "all 65536 levels rise from 0 to 1" rises;
      case "PFM is linear, bit for bit" floats;
      case "light is finite and not negative, reflectance in [0;1]" bad_values;
      case "what the encoders write is read" encoders;
      case "what is no picture is told from what is" wrong_files;
      case "a picture has at most 65536 pixels each way" too_wide;
      case "what cannot be read is told" missing;
      case "damaged files are errors, never exceptions" damaged;
    ] )
