open Candor_read
open Text

let check name expected text = Meshes.check name Ply.read expected text
let refused expected text = Meshes.refused Ply.read expected text

(* {1 The same mesh in text and in bytes} *)

let header form =
  String.concat "\n"
    [
      "ply";
      "format " ^ form ^ " 1.0";
      "comment what to see";
      "element material 2";
      "property uchar red";
      "property list uint8 float weights";
      "element vertex 4";
      "property float x";
      "property double y";
      "property int16 z";
      "property float nx";
      "property float ny";
      "property float nz";
      "property list uchar uint extra";
      "property float s";
      "property float t";
      "obj_info nothing";
      "element face 2";
      "property uchar red";
      "property list ushort int vertex_indices";
      "element nothing 1000000000000";
      "end_header\n";
    ]

let vertices =
  [ (0., 0., 0); (1., 0., 0); (1., 1., -2); (0., 1., -2) ]
  |> List.map (fun (x, y, z) -> (x, y, z, x, 0.25))

let faces = [ [ 0; 1; 2 ]; [ 0; 1; 2; 3 ] ]

let in_text =
  let vertex (x, y, z, s, t) =
    Printf.sprintf "%g %g %d 0 2 1 2 7 8 %g %g\n" x y z s t
  and face f =
    Printf.sprintf "200 %d %s\n" (List.length f)
      (String.concat " " (List.map string_of_int f))
  in
  header "ascii" ^ "9 0\n\n9 2 .5 .5\r\n"
  ^ String.concat "" (List.map vertex vertices @ List.map face faces)

let in_bytes ~big =
  let b = Buffer.create 1000 in
  let u8 = Buffer.add_uint8 b
  and i16 = if big then Buffer.add_int16_be b else Buffer.add_int16_le b
  and i32 = if big then Buffer.add_int32_be b else Buffer.add_int32_le b
  and i64 = if big then Buffer.add_int64_be b else Buffer.add_int64_le b in
  let int n = i32 (Int32.of_int n) and real x = i32 (Int32.bits_of_float x) in
  Buffer.add_string b
    (header (if big then "binary_big_endian" else "binary_little_endian"));
  u8 9;
  u8 0;
  u8 9;
  u8 2;
  real 0.5;
  real 0.5;
  List.iter
    (fun (x, y, z, s, t) ->
      real x;
      i64 (Int64.bits_of_float y);
      i16 z;
      real 0.;
      real 2.;
      real 1.;
      u8 2;
      int 7;
      int 8;
      real s;
      real t)
    vertices;
  List.iter
    (fun face ->
      u8 200;
      i16 (List.length face);
      List.iter int face)
    faces;
  Buffer.contents b

let expected =
  let n = "n(0 2 1)(0 2 1)(0 2 1)" in
  [
    "0 dropped";
    "(0 0 0)(1 0 0)(1 1 -2) " ^ n ^ " t(0 0.25)(1 0.25)(1 0.25)";
    "(0 0 0)(1 0 0)(1 1 -2) " ^ n ^ " t(0 0.25)(1 0.25)(1 0.25)";
    "(0 0 0)(1 1 -2)(0 1 -2) " ^ n ^ " t(0 0.25)(1 0.25)(0 0.25)";
  ]

let forms () =
  check "text" expected in_text;
  check "bytes, the last first" expected (in_bytes ~big:false);
  check "bytes, the first first" expected (in_bytes ~big:true)

(* {1 Short ones} *)

let ply ?(face = "list uchar int vertex_index") ?(vertex = "x y z") body =
  let property p = "property float " ^ p ^ "\n" in
  let rows = String.split_on_char ' ' vertex |> List.map property in
  "ply\nformat ascii 1.0\nelement vertex 3\n" ^ String.concat "" rows
  ^ "element face 1\nproperty " ^ face ^ "\nend_header\n" ^ body

let body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"

let short () =
  check "the least" [ "0 dropped"; "(0 0 0)(1 0 0)(0 1 0)" ] (ply body);
  check "uv by u and v"
    [ "0 dropped"; "(0 0 0)(1 0 0)(0 1 0) t(1 2)(3 4)(5 6)" ]
    (ply ~vertex:"u v x y z" "1 2 0 0 0\n3 4 1 0 0\n5 6 0 1 0\n3 0 1 2")

let errors () =
  refused "line 1: a PLY file begins with `ply`" "plyx\n";
  refused "line 2: expected `format` in the second line" "ply\nelement";
  refused
    "line 2: expected ascii, binary_little_endian or binary_big_endian, not \
     `binary`"
    "ply\nformat binary";
  refused "line 3: the file ends before its `end_header`" "ply\nformat ascii\n";
  refused "line 3: `-1` is not a number of rows"
    "ply\nformat ascii\nelement vertex -1";
  refused "line 3: a property of what? No element is above"
    "ply\nformat ascii\nproperty float x";
  refused "line 4: `real` is not a type of PLY"
    "ply\nformat ascii\nelement vertex 1\nproperty real x";
  refused "line 4: the length of a list is a whole number"
    "ply\nformat ascii\nelement face 1\nproperty list float int a";
  refused
    "line 3: expected element, property, comment or end_header, not `vertex`"
    "ply\nformat ascii\nvertex";
  refused "line 9: a vertex needs the properties x, y and z"
    (ply ~vertex:"x y" body);
  refused "line 13: a face needs a list of whole numbers called vertex_indices"
    (ply ~face:"list uchar float vertex_index" body);
  refused "line 10: expected a number, not the end of the line"
    (ply "0 0\n0 1 0 0\n");
  refused "line 10: more numbers than the properties of this row"
    (ply "0 0 0 0\n");
  refused "line 10: `x` is not a number" (ply "0 x 0\n");
  refused "line 10: coordinates must be finite and at most 2^400 in size"
    (ply "0 1e200 0\n");
  refused "line 12: the file ends early" (ply "0 0 0\n0 0 0\n");
  let face = "0 0 0\n1 0 0\n0 1 0\n" in
  refused "line 13: there is no vertex 3: 3 are above" (ply (face ^ "3 0 1 3"));
  refused "line 13: there is no vertex -1: 3 are above"
    (ply (face ^ "3 0 1 -1"));
  refused "line 13: 0.5 is not a whole number" (ply (face ^ "3 0 1 .5"));
  refused "line 13: a face needs three corners or more, not 2"
    (ply (face ^ "2 0 1"));
  refused "line 13: a list cannot have a negative length" (ply (face ^ "-3 0"));
  refused "line 13: the file ends early" (ply (face ^ "4000000000 0"));
  refused "the file has no faces" "ply\nformat ascii 1.0\nend_header\n"

let binary_errors () =
  let whole = in_bytes ~big:false in
  let n = String.length whole in
  refused "face 1: the file ends early" (String.sub whole 0 (n - 1));
  let changed = Bytes.of_string whole in
  Bytes.set changed (n - 1) '\001';
  refused "face 1: there is no vertex 16777219: 4 are above"
    (Bytes.to_string changed)

let damaged () =
  Meshes.survives Ply.read in_text;
  Meshes.survives Ply.read (in_bytes ~big:false);
  Meshes.survives Ply.read (in_bytes ~big:true)

let suite =
  ( "PLY",
    [
      case "text and bytes of either order say the same" forms;
      case "elements and properties have their places in any order" short;
      case "what is wrong is told with its line" errors;
      case "in bytes, with its row" binary_errors;
      case "damaged files are errors, never exceptions" damaged;
    ] )
