open Candor_image_hidden
open Support
open QCheck2

let most = 0x10000000
let fits (width, height) = Result.is_ok (Extent.check ~width ~height)

let examples () =
  let check expected size =
    Alcotest.(check bool)
      (Printf.sprintf "%d x %d" (fst size) (snd size))
      expected (fits size)
  in
  List.iter (check true)
    [ (1, 1); (most, 1); (1, most); (0x4000, 0x4000); (0x3fff, 0x4001) ];
  List.iter (check false)
    [ (0, 1); (1, 0); (-1, 1); (1, -1); (-1, -1); (min_int, min_int) ];
  List.iter (check false)
    [ (most + 1, 1); (1, most + 1); (0x4000, 0x4001); (0x4001, 0x4000) ]

(* These products are 0, or small, in machine words. *)
let overflows () =
  let check size =
    Alcotest.(check bool)
      (Printf.sprintf "%d x %d" (fst size) (snd size))
      false (fits size)
  in
  List.iter check
    [
      (1 lsl 32, 1 lsl 32);
      (max_int, max_int);
      (max_int, 2);
      ((1 lsl 31) + 1, 1 lsl 32);
      (1 lsl 61, 4);
    ]

let said () =
  let check expected ~width ~height =
    Alcotest.(check (result unit string))
      expected (Error expected)
      (Extent.check ~width ~height)
  in
  check "a picture of 7 x 0 pixels has no pixel" ~width:7 ~height:0;
  check "65536 x 4097 pixels are too many: the most is 268435456" ~width:65536
    ~height:4097

(* Near a power of two, where the limit is. *)
let size =
  let side =
    Gen.map2
      (fun k off -> (1 lsl k) + off)
      (Gen.int_bound 34) (Gen.int_range (-2) 2)
  in
  Gen.pair side side

let limited =
  law "a size is allowed iff it has a pixel, and at most 2^28" ~count:5000
    ~print:Print.(pair int int)
    size
    (fun (w, h) ->
      let small n = 1 <= n && n <= most in
      fits (w, h) = (small w && small h && w * h <= most))

let suite =
  ( "extent",
    [
      unit "the largest sizes are allowed and no larger ones" examples;
      unit "products that overflow are too large" overflows;
      unit "the error tells the size, and the limit" said;
      limited;
    ] )
