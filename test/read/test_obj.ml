open Candor_read
open Text

let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
let check name expected text = Meshes.check name Obj.read expected text
let refused expected text = Meshes.refused Obj.read expected text

let corners () =
  check "vertices alone"
    [ "0 dropped"; "(0 0 0)(1 0 0)(1 1 0)" ]
    (square ^ "f 1 2 3");
  check "from the last"
    [ "0 dropped"; "(0 0 0)(1 0 0)(0 1 0)"; "(0 0 0)(1 1 0)(0 1 0)" ]
    (square ^ "f -4 -3 -1\nf -4 3 4");
  check "from the last above the face"
    [ "0 dropped"; "(0 0 0)(1 0 0)(1 1 0)"; "(1 1 0)(0 1 0)(5 5 5)" ]
    (square ^ "f -4 -3 -2\nv 5 5 5\nf -3 -2 -1")

let attributes () =
  let more = "vn 0 0 1\nvn 0 1 1\nvt .5 .25 7\nvt 1\n" in
  check "normals"
    [ "0 dropped"; "(0 0 0)(1 0 0)(1 1 0) n(0 0 1)(0 1 1)(0 1 1)" ]
    (square ^ more ^ "f 1//1 2//2 3//-1");
  check "uv"
    [ "0 dropped"; "(0 0 0)(1 0 0)(1 1 0) t(0.5 0.25)(1 0)(0.5 0.25)" ]
    (square ^ more ^ "f 1/1 2/2 3/-2");
  check "both, round a face of four corners"
    [
      "0 dropped";
      "(0 0 0)(1 0 0)(1 1 0) n(0 0 1)(0 0 1)(0 1 1) t(0.5 0.25)(1 0)(1 0)";
      "(0 0 0)(1 1 0)(0 1 0) n(0 0 1)(0 1 1)(0 0 1) t(0.5 0.25)(1 0)(1 0)";
    ]
    (square ^ more ^ "f 1/1/1 2/2/1 3/2/2 4/2/1");
  check "not at all corners"
    [ "0 dropped"; "(0 0 0)(1 0 0)(1 1 0)" ]
    (square ^ more ^ "f 1/1/1 2//1 3/1");
  check "a normal of zero"
    [ "0 dropped"; "(0 0 0)(1 0 0)(1 1 0)" ]
    (square ^ "vn 0 0 1\nvn 0 0 0\nf 1//1 2//1 3//2")

let others () =
  check "what is left aside"
    [ "0 dropped"; "(0 0 0)(1 0 0)(1 1 0)" ]
    ("# comment\r\nmtllib a.mtl\n\no x\ng\ns 1\nusemtl y\nvp 1 2\nl 1 2\n"
   ^ "v 0 0 0 1 # w\r\nv 1 0 0 .5 .5 .5\nv 1 1 \\\n 0\nf 1 2 \\\r\n 3 # end");
  check "no area"
    [ "1 dropped"; "(0 0 0)(1 0 0)(1 1 0)" ]
    (square ^ "f 1 2 1\nf 1 2 3")

let errors () =
  refused "line 1: expected z, not the end of the line" "v 1 2\nf 1 2 3";
  refused "line 2: `x` is not a number" "# a\nv 1 x 2";
  refused "line 2: `nan` is not a number" "\nvn 0 0 nan";
  refused "line 1: coordinates must be finite and at most 2^400 in size"
    "v 1e200 0 0";
  refused "line 1: `b` is not a number" "vt 0 b";
  refused "line 5: a face needs three corners or more, not 2" (square ^ "f 1 2");
  refused "line 5: there is no v 5: 4 are above" (square ^ "f 1 2 5\nv 0 0 0");
  refused "line 5: there is no v 0: 4 are above" (square ^ "f 1 2 0");
  refused "line 5: there is no v -5: 4 are above" (square ^ "f 1 2 -5");
  refused "line 5: there is no vt 1: 0 are above" (square ^ "f 1/1 2 3");
  refused "line 5: there is no vn 1: 0 are above" (square ^ "f 1//1 2 3");
  refused "line 5: `0x1` is not the number of a corner" (square ^ "f 0x1 2 3");
  refused "line 5: `//1` has no number of a vertex" (square ^ "f //1 2 3");
  refused "line 5: expected v/vt/vn, not `1/2/3/4`" (square ^ "f 1/2/3/4 2 3");
  refused "the file has no faces" square;
  refused "the file has no faces" "";
  refused "no face of the file has an area" (square ^ "f 1 1 1")

let damaged () =
  Meshes.survives Obj.read
    (square ^ "vt 0 1\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1 4/-1/-1\nf 1 2 \\\n4 # x\n")

(* Time in step with the size: ten times as much takes far less than a hundred
   times as long. *)
let linear () =
  let text n =
    let b = Buffer.create (n * 60) in
    for i = 1 to n do
      Printf.bprintf b "v %d 0 0\nv %d 1 0\nv %d 0 1\nf -3 -2 -1\n" i i i
    done;
    Buffer.contents b
  in
  let words n =
    let text = text n in
    let before = Gc.minor_words () in
    match Obj.read text with
    | Ok m ->
        Alcotest.(check int) "triangles" n (Array.length m.triangles);
        Gc.minor_words () -. before
    | Error why -> Alcotest.fail why
  in
  is "linear" true (words 20_000 < 12. *. words 2_000)

let suite =
  ( "OBJ",
    [
      case "corners count from the first or from the last" corners;
      case "normals and uv are read where all corners have them" attributes;
      case "other statements and comments are left aside" others;
      case "what is wrong is told with its line" errors;
      case "damaged files are errors, never exceptions" damaged;
      case "work grows in step with the size" linear;
    ] )
