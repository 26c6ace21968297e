open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2

let edge = 0x1p400
let beyond = Float.succ edge

let lengths () =
  List.iter
    (fun (x, expected) ->
      Alcotest.(check bool) (Printf.sprintf "%h" x) expected (Reach.length x))
    [
      (0., true);
      (-0., true);
      (5e-324, true);
      (edge, true);
      (-.edge, true);
      (Float.pred edge, true);
      (beyond, false);
      (-.beyond, false);
      (max_float, false);
      (infinity, false);
      (neg_infinity, false);
      (nan, false);
    ]

let number =
  Gen.oneof
    [
      Draw.any_coordinate;
      Draw.pick [ edge; -.edge; beyond; -.beyond; infinity; nan ];
    ]

let all_of (x, y, z) =
  let each = Reach.length x && Reach.length y && Reach.length z in
  Bool.equal each (Reach.point (Point.v x y z))
  && Bool.equal each (Reach.vec (Vec.v x y z))

let message () =
  List.iter
    (fun word ->
      let words = String.split_on_char ' ' Reach.message in
      Alcotest.(check bool) word true (List.mem word words))
    [ "finite"; "2^400" ]

let suite =
  ( "reach",
    [
      Law.example "lengths reach up to 2^400 and no further" lengths;
      Law.law
        ~print:(fun (x, y, z) -> Printf.sprintf "%h %h %h" x y z)
        "a point or vector is within reach if each coordinate is"
        Gen.(triple number number number)
        all_of;
      Law.example "the message names the limit" message;
    ] )
