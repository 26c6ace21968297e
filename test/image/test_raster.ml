open Candor_image
open Support

let tests =
  [
    unit "init asks in the order of a file" (fun () ->
        let next = ref 0 in
        let count _ _ _ =
          incr next;
          Ok (!next - 1)
        in
        Alcotest.check decoded "in order"
          (Ok (raster_of ~width:2 ~height:2 ~maxval:20 (Array.init 12 Fun.id)))
          (Raster.init ~width:2 ~height:2 ~maxval:20 count));
    unit "a sample above the largest value is an error" (fun () ->
        Alcotest.check decoded "too large"
          (Error "a sample is 8, outside 0 .. 7")
          (Raster.init ~width:1 ~height:1 ~maxval:7 (fun _ _ _ -> Ok 8)));
    unit "the first error ends init" (fun () ->
        let calls = ref 0 in
        let fail _ _ _ =
          incr calls;
          Error "no"
        in
        Alcotest.check decoded "error" (Error "no")
          (Raster.init ~width:4 ~height:4 ~maxval:1 fail);
        Alcotest.(check int) "one call" 1 !calls);
    unit "a raster of a picture holds the numbers smallpt would show" (fun () ->
        let p = picture_of ~width:2 ~height:1 [| 0.; 0.5; 1.; 2.; -1.; nan |] in
        Alcotest.check raster "levels"
          (raster_of ~width:2 ~height:1 ~maxval:255
             [| 0; 186; 255; 255; 0; 0 |])
          (Raster.of_picture p));
    unit "a sample outside the raster is the caller's mistake" (fun () ->
        let r = raster_of ~width:1 ~height:1 ~maxval:1 [| 0; 0; 0 |] in
        match Raster.sample r 0 0 3 with
        | _ -> Alcotest.fail "accepted"
        | exception Invalid_argument _ -> ());
  ]

let suite = ("raster", tests)
