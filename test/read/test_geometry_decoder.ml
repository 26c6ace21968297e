open Candor_space
open Candor_read
open Text

let point = Geometry_decoder.point
let vector = Geometry_decoder.vector
let direction = Geometry_decoder.direction
let size = Geometry_decoder.size "R"
let length = Geometry_decoder.length "D"
let radii = Geometry_decoder.radii

let points () =
  Piece.reads Point.equal point "(p 1 -2.5 3e2)" (Point.v 1. (-2.5) 300.);
  Piece.reads Point.equal point "(p 0x1p400 -0x1p400 0)"
    (Point.v 0x1p400 (-0x1p400) 0.);
  Piece.reads Vec.equal vector "(p 1 -2.5 3e2)" (Vec.v 1. (-2.5) 300.);
  Piece.reads Vec.equal vector "(p 0 0 0)" Vec.zero

let no_points () =
  let check b =
    Piece.refuses b "(p 1 2)" [ "1 expected (p X Y Z), found 2 words" ];
    Piece.refuses b "(p 1 2 3 4)" [ "1 expected (p X Y Z), found 4 words" ];
    Piece.refuses b "(p 1 nan 3)" [ "6 `nan` is not a number" ];
    Piece.refuses b "(p 1 (2) 3)" [ "6 expected a number, not (2 ...)" ];
    Piece.refuses b "(p 1 2 -0x1.0000000000001p400)"
      [
        "8 Z of (p ...) must be at most 2^400 in size, but is \
         `-0x1.0000000000001p400`";
      ]
  in
  check (Decode.map ignore point);
  check (Decode.map ignore vector);
  check (Decode.map ignore direction)

let directions () =
  Piece.reads Vec.equal direction "(d 0 -3 4)" (Vec.v 0. (-3.) 4.);
  Piece.reads Vec.equal direction "(d 0 0 0x1p-1074)" (Vec.v 0. 0. 0x1p-1074);
  let zero = [ "1 (d ...): a direction must not be zero" ] in
  Piece.refuses direction "(d 0 0 0)" zero;
  Piece.refuses direction "(d -0 0 -0)" zero;
  Piece.refuses direction "(d 1e-999 0 0)" zero

let lengths () =
  Piece.reads Float.equal length "(d -3)" (-3.);
  Piece.reads Float.equal length "(d 0)" 0.;
  Piece.refuses length "(d 1e300)"
    [ "4 (d ...) must be at most 2^400 in size, but is `1e300`" ];
  Piece.refuses length "(d)" [ "1 expected (d D), found nothing" ]

let sizes () =
  Piece.reads Float.equal size "(r 2)" 2.;
  Piece.reads Float.equal size "(r 0x1p-400)" 0x1p-400;
  Piece.reads Float.equal size "(r 0x1p400)" 0x1p400;
  Piece.refuses size "(r 0)" [ "4 (r ...) must be above 0, but is `0`" ];
  Piece.refuses size "(r 0x1p-401)"
    [ "4 (r ...) must be at least 2^-400, but is `0x1p-401`" ];
  Piece.refuses size "(r 0x1p401)"
    [ "4 (r ...) must be at most 2^400, but is `0x1p401`" ];
  Piece.refuses size "(r 1 2)" [ "1 expected (r R), found 2 words" ];
  Piece.reads Vec.equal radii "(r 1 2 .5)" (Vec.v 1. 2. 0.5);
  Piece.refuses radii "(r 1 0 -1)"
    [
      "6 B of (r ...) must be above 0, but is `0`";
      "8 C of (r ...) must be above 0, but is `-1`";
    ]

let boxes () =
  let b = Geometry_decoder.bounds in
  let expected = Bounds.v (Point.v 1. 2. 3.) (Point.v 4. 5. 6.) in
  Piece.reads Bounds.equal b "(b (min 1 2 3) (max 4 5 6))" expected;
  Piece.reads Bounds.equal b "(b (max 4 5 6) (min 1 2 3))" expected;
  Piece.refuses b "(b (min 1 2 3))" [ "1 (b ...) needs (max X Y Z)" ];
  Piece.refuses b "(b (max 1 2 3))" [ "1 (b ...) needs (min X Y Z)" ];
  Piece.refuses b "(b (min 1 2 3) (max 4 5 6) (mid 0 0 0))"
    [ "28 unknown field `mid` in (b ...); did you mean `min`?" ]

let triple = QCheck2.Gen.(triple Piece.number Piece.number Piece.number)

let law name =
  law ~count:1000 ~print:QCheck2.Print.(triple float float float) name triple

let read b (x, y, z) = fst (Piece.body b (Printf.sprintf "(p %h %h %h)" x y z))

let all_in_reach (x, y, z) =
  List.for_all (fun c -> Float.abs c <= 0x1p400) [ x; y; z ]

let same (x, y, z) (x', y', z') =
  Piece.(same_bits x x' && same_bits y y' && same_bits z z')

let suite =
  ( "geometry decoder",
    [
      case "points and vectors are three coordinates" points;
      case "what is no point is told, part by part" no_points;
      law "a point is any three numbers up to 2^400, to the bit" (fun p ->
          match read point p with
          | Some q -> all_in_reach p && same p (q.x, q.y, q.z)
          | None -> not (all_in_reach p));
      law "a direction is as written" (fun p ->
          match read direction p with
          | Some q -> all_in_reach p && same p (q.x, q.y, q.z)
          | None -> (not (all_in_reach p)) || p = (0., 0., 0.));
      case "only zero is no direction" directions;
      case "lengths may be negative" lengths;
      case "sizes are above 0, and neither vanish nor overflow" sizes;
      law "radii are three sizes" (fun p ->
          let x, y, z = p in
          let is_size r = 0x1p-400 <= r && r <= 0x1p400 in
          match read radii p with
          | Some q -> List.for_all is_size [ x; y; z ] && same p (q.x, q.y, q.z)
          | None -> not (List.for_all is_size [ x; y; z ]));
      case "bounds are their least and their greatest corner" boxes;
    ] )
