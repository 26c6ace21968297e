open Candor_read
open Candor_space
open Text

let print = Scene_printer.to_string

let reads_back scene =
  let text = print scene in
  match read text with
  | Error report -> QCheck2.Test.fail_reportf "%s\n%s" text (show report)
  | Ok scene' ->
      (same scene scene' && String.equal text (print scene'))
      || QCheck2.Test.fail_reportf "%s\nreads as\n%s" text (print scene')

let reads_as_printed =
  law ~count:400 "what is printed reads as the same scene, bit by bit"
    (Draw_scene.gen Draw_scene.scene)
    reads_back

let normals_keep_their_bits =
  law ~count:4000 "the normals of a triangle read as they were written"
    (Draw_scene.gen Draw_scene.direction) (fun n ->
      let (n : Vec.t) = n in
      let text =
        Printf.sprintf
          "(triangle (0 0 0) (1 0 0) (0 1 0) (normals (%h %h %h) (0 0 1) (0 0 \
           1)))"
          n.x n.y n.z
      in
      reads_back (ok (scene text)))

let lines text = String.split_on_char '\n' text
let fits text = List.for_all (fun line -> String.length line <= 80) (lines text)

let narrow () =
  let text =
    print
      (ok_forms
         "(group (transform (matrix 1.23456789 0.123456789 0 3.23456789 0 \
          1.987654321 0 1.55555555 0 0 1.44444444 1.333333333)) (sphere \
          (center 1.5 2.5 3.5) (radius .25) (material (glazed (color (checker \
          (rgb .125 .25 .5) .75 (scale 2.5))) (mirror .25)))))")
  in
  Alcotest.(check bool) text true (fits text)

let readable () =
  Alcotest.(check string)
    "layout"
    "(scene\n\
    \  (image (size 640 480))\n\
    \  (render (spp 16) (cutoff 0) (seed 0) (filter box))\n\
    \  (camera (perspective (eye 0 1 5) (look-at 0 1 0) (up 0 1 0) (fov-y 40)))\n\
    \  (background 0)\n\
    \  (material red (matte (color (rgb 0.9 0.1 0.1))))\n\
    \  (group\n\
    \    (transform (translate 1 0 0) (scale 2 2 2))\n\
    \    (sphere (center 0 1 0) (radius 0.25) (material red))\n\
    \    (quadric\n\
    \      (cylinder (from 0 0 0) (to 0 1 0) (radius 1))\n\
    \      (clip (min -1 -1 -1) (max 1 1 1))\n\
    \      (caps))))\n"
    (print
       (ok_forms
          "(material red (matte (color (rgb .9 .1 .1)))) (group (transform \
           (translate 1 0 0) (scale 2)) (sphere (center 0 1 0) (radius .25) \
           (material red)) (quadric (cylinder (from 0 0 0) (to 0 1 0) (radius \
           1)) (clip (min -1 -1 -1) (max 1 1 1)) (caps)))"))

let pictures () =
  Files.with_folder (fun folder ->
      let (_ : string) = Files.write folder "a b.ppm" "P3 1 1 255 9 8 7" in
      let read text =
        match Scene_file.read (Files.write folder "a.scene" text) with
        | Ok scene -> scene
        | Error report -> Alcotest.fail (show report)
      in
      let s =
        read
          (scene
             "(background (image \"a b.ppm\")) (sphere (center 0 0 0) (radius \
              1) (material (matte (color (noise (image \"a b.ppm\") 1)))))")
      in
      is "reads back" true (same s (read (print s))))

let suite =
  ( "scene printer",
    [
      reads_as_printed;
      normals_keep_their_bits;
      case "pictures keep their names" pictures;
      case "lines hold at most 80 columns" narrow;
      case "the layout is that of a person" readable;
    ] )
