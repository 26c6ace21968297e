(** Pictures to test with, and words to test in. *)

open Candor_colour
open Candor_image
open QCheck2

let unit name f = Alcotest.test_case name `Quick f

let law ?(count = 300) ?print name gen f =
  QCheck_alcotest.to_alcotest (Test.make ~count ?print ~name gen f)

let raster =
  let pp out r =
    Format.fprintf out "%dx%d of 0..%d:" (Raster.width r) (Raster.height r)
      (Raster.maxval r);
    for y = 0 to Raster.height r - 1 do
      for x = 0 to Raster.width r - 1 do
        for c = 0 to 2 do
          Format.fprintf out " %d" (Raster.sample r x y c)
        done
      done
    done
  in
  Alcotest.testable pp Raster.equal

let decoded = Alcotest.(result raster string)
let same_decoded = Result.equal ~ok:Raster.equal ~error:String.equal

let raster_of ~width ~height ~maxval samples =
  match
    Raster.init ~width ~height ~maxval (fun x y c ->
        Ok samples.((3 * ((y * width) + x)) + c))
  with
  | Ok r -> r
  | Error e -> Alcotest.fail e

let picture_of ~width ~height numbers =
  Picture.init ~width ~height (fun x y ->
      let at c = numbers.((3 * ((y * width) + x)) + c) in
      Rgb.v (at 0) (at 1) (at 2))

let odd_numbers =
  [ nan; infinity; neg_infinity; -1.; -0.; 0.; 1.; 5e-324; 1e-42; max_float ]

(** [pick xs] is one of [xs]. *)
let pick xs = Gen.oneof (List.map Gen.pure xs)

(** Mostly ordinary, now and then odd. *)
let number =
  let open Gen in
  let* n = int_bound 6 in
  if n = 0 then pick odd_numbers else float_range 0. 1.2

let side = Gen.int_range 1 9

let picture_with number =
  let open Gen in
  let* width = side in
  let* height = side in
  let+ numbers = array_size (pure (3 * width * height)) number in
  picture_of ~width ~height numbers

let picture = picture_with number

let show_picture p =
  let row y =
    String.concat " "
      (List.init (Picture.width p) (fun x -> Rgb.show (Picture.pixel p x y)))
  in
  String.concat "\n" (List.init (Picture.height p) row)

(** [damage file] is [file] cut short, or with some bits flipped. *)
let damage file =
  let open Gen in
  let last = String.length file - 1 in
  let flip file (at, bit) =
    let bytes = Bytes.of_string file in
    Bytes.set_uint8 bytes at (Bytes.get_uint8 bytes at lxor (1 lsl bit));
    Bytes.to_string bytes
  in
  let flips = list_size (int_range 1 4) (pair (int_bound last) (int_bound 7)) in
  oneof
    [
      map (String.sub file 0) (int_bound last);
      map (List.fold_left flip file) flips;
    ]

(** [survives decode file] is [true] unless [decode file] raises. *)
let survives decode file =
  match decode file with Ok _ -> true | Error message -> message <> ""
