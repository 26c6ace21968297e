open Candor_colour
open Candor_image
open Support

let place x y = Rgb.v (float_of_int x) (float_of_int y) 0.5

let tests =
  [
    unit "a pixel is what init's function gave for its column and row"
      (fun () ->
        let p = Picture.init ~width:3 ~height:2 place in
        Alcotest.(check int) "width" 3 (Picture.width p);
        Alcotest.(check int) "height" 2 (Picture.height p);
        Alcotest.(check bool)
          "pixel" true
          (Rgb.equal (place 2 1) (Picture.pixel p 2 1)));
    unit "rows of the wrong length are the caller's mistake" (fun () ->
        match Picture.of_rows ~width:2 [| Float.Array.create 5 |] with
        | _ -> Alcotest.fail "accepted"
        | exception Invalid_argument _ -> ());
    law "a picture equals itself, even with nan in it" picture (fun p ->
        Picture.equal p p);
  ]

let suite = ("picture", tests)
