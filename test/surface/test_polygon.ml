open Candor_space
open Candor_surface
open Outline

let test_known (name, outline, area', count) =
  Alcotest.test_case (name ^ " has its area") `Quick @@ fun () ->
  let triangles = filled outline and exact = List.map spot outline in
  check_q "as known" area' (true_area exact);
  check_q "as filled" area' (Q.abs (area triangles));
  Alcotest.(check int) "triangles" count (List.length triangles);
  Alcotest.(check bool) "sealed" true (sealed triangles);
  Alcotest.(check bool) "one way" true (same_way triangles);
  Alcotest.(check bool) "covered" true (covers_all exact triangles (grid 11))

let test_pentagram () =
  let triangles = filled pentagram and exact = List.map spot pentagram in
  Alcotest.(check int) "triangles" 8 (List.length triangles);
  Alcotest.(check bool) "sealed" true (sealed triangles);
  Alcotest.(check bool) "counter-clockwise" true (Q.sign (area triangles) > 0);
  Alcotest.(check bool)
    "area" true
    (close_to (true_area exact) (area triangles));
  Alcotest.(check bool)
    "the centre" true
    (covers exact triangles { x = half; y = Q.of_ints 1 3 })

let test_facing () =
  let way outline = Q.sign (area (filled outline)) in
  Alcotest.(check int) "counter-clockwise" 1 (way square);
  Alcotest.(check int) "clockwise" (-1) (way (List.rev square));
  Alcotest.(check int) "first turn" (-1) (way bow_tie);
  Alcotest.(check int) "first turn" 1 (way [ (0, 0); (4, 0); (0, 4); (4, 4) ])

let many =
  let zigzag n =
    List.init n (fun i -> (i, i mod 2))
    @ List.init n (fun i -> (n - 1 - i, 2 + ((n - 1 - i) mod 2)))
  in
  [
    ("star of 1001 points", star 1001);
    ("comb of 1000 teeth", comb 999);
    ("spiral of 250 turns", spiral 250);
    ("zigzag of 2000 corners", zigzag 1000);
  ]

let test_many (name, outline) =
  let title = "a " ^ name ^ " has two triangles fewer than corners" in
  Alcotest.test_case title `Quick @@ fun () ->
  let triangles = filled outline in
  Alcotest.(check int)
    "triangles"
    (List.length outline - 2)
    (List.length triangles);
  check_q "area" (shoelace (List.map spot outline)) (area triangles)

(* {1 Errors} *)

let check_refused why corners =
  let got = Result.map ignore (Polygon.make corners) in
  Alcotest.(check (result unit string)) "refused" (Error why) got

let few = "a polygon needs at least three different corners"
let flat = "the polygon has no area"

let test_degenerate () =
  check_refused few [];
  check_refused few [ point (1, 2) ];
  check_refused few (List.map point [ (1, 2); (3, 4) ]);
  check_refused few (List.map point [ (1, 2); (1, 2); (1, 2); (1, 2) ]);
  check_refused few (List.map point [ (1, 2); (3, 4); (1, 2); (3, 4) ]);
  check_refused flat (List.map point [ (0, 0); (1, 2); (3, 6); (2, 4) ]);
  check_refused flat (List.map point [ (0, 0); (5, 0); (0, 0); (0, 5) ]);
  check_refused flat (List.map point (square @ List.rev square));
  check_refused flat
    (List.map (fun t -> Point.v t (2. *. t) (-3. *. t)) [ 0.1; 0.7; 0.3 ])

let test_reach () =
  let beyond = "coordinates must be finite and at most 2^400 in size" in
  let with_x x = Point.v x 0. 0. :: List.map point square in
  List.iter
    (fun x -> check_refused beyond (with_x x))
    [ nan; infinity; 0x1p401 ];
  Alcotest.(check int) "2^400" 5 (List.length (with_x 0x1p400));
  ignore (made (Point.v 0x1p400 1. 0. :: List.map point square))

let lifted corner height =
  let lift i (x, y) =
    let angle = Float.pi *. float_of_int ((2 * x) + y) /. 4. in
    let z = if i + 1 = corner then height else 0. in
    Point.v (Float.cos angle) (Float.sin angle) z
  in
  List.mapi lift
    [ (0, 0); (0, 1); (1, 0); (1, 1); (2, 0); (2, 1); (3, 0); (3, 1) ]

let test_plane () =
  let off i = Printf.sprintf "corner %d is off the plane of the others" i in
  for corner = 1 to 8 do
    check_refused (off corner) (lifted corner 0x1p-36);
    check_refused (off corner) (lifted corner 0.1);
    ignore (made (lifted corner 0x1p-42))
  done

(* {1 Random outlines} *)

let law ?(count = 150) name gen holds =
  let corner (x, y) = Printf.sprintf "(%d, %d)" x y in
  let print outline = String.concat " " (List.map corner outline) in
  Candor_oracle.Law.law ~count ~print name gen holds

let coordinate n = QCheck2.Gen.int_range (-n) n
let place n = QCheck2.Gen.pair (coordinate n) (coordinate n)
let tangle = QCheck2.Gen.(list_size (int_range 3 14) (place 6))
let wild = QCheck2.Gen.(list_size (int_range 3 14) (place 1000))

(* Seen whole from the origin: one corner in each of some directions, three of
   which go all the way round. *)
let star_shaped =
  let upper (x, y) = y > 0 || (y = 0 && x > 0) in
  let by_angle ((a, b) as p) ((c, d) as q) =
    match Bool.compare (upper q) (upper p) with
    | 0 -> Int.compare (b * c) (a * d)
    | order -> order
  in
  let somewhere (x, y) = x <> 0 || y <> 0 in
  let outline places =
    let places = List.filter somewhere places in
    List.sort_uniq by_angle ((7, 0) :: (-3, 6) :: (-2, -5) :: places)
  in
  QCheck2.Gen.(map outline (list_size (int_range 0 20) (place 9)))

let fills_exactly outline triangles =
  let exact = List.map spot outline in
  List.length triangles = List.length outline - 2
  && Q.equal (area triangles) (shoelace exact)
  && sealed triangles && same_way triangles
  && covers_all exact triangles (grid 9)

let star_law =
  law "a polygon seen whole from a point is filled exactly" star_shaped
  @@ fun outline -> fills_exactly outline (filled outline)

let maybe_filled outline =
  match Polygon.make (List.map point outline) with
  | Ok polygon -> List.map spots polygon.triangles
  | Error _ -> []

(* Points in no reach of the crossings' rounding: on a fine grid, off all lines. *)
let samples =
  let scatter i =
    {
      x = Q.of_ints ((i * 7919 mod 26003) - 13001) 2000;
      y = Q.of_ints ((i * 104729 mod 26003) - 13001) 2001;
    }
  in
  List.init 50 scatter

let far_from outline r =
  let clear (p, q) =
    Q.gt (Q.abs (cross p q r)) (Q.of_float 0x1p-30) || equal p q
  in
  List.for_all clear (sides outline)

let fills outline samples triangles =
  let exact = List.map spot outline in
  let clear = List.filter (far_from exact) samples in
  close_to (true_area exact) (Q.abs (area triangles))
  && List.for_all (covers exact triangles) clear

let fills_neatly outline samples =
  let triangles = maybe_filled outline in
  fills outline samples triangles
  && sealed triangles
  && (List.is_empty triangles || same_way triangles)

let tangle_law =
  law "a tangle on a small grid is filled where it winds" tangle
  @@ fun outline -> fills_neatly outline samples

let wild_law =
  let wide { x; y } =
    { x = Q.mul x (Q.of_int 150); y = Q.mul y (Q.of_int 150) }
  in
  law ~count:60 "a tangle of long sides is filled where it winds" wild
  @@ fun outline -> fills_neatly outline (List.map wide samples)

let corners_law =
  law "crossing sides meet in corners that all neighbours share" wild
  @@ fun outline ->
  let triangles = maybe_filled outline in
  let sides = triangle_sides triangles in
  let order (p, q) (r, s) =
    List.find_opt (( <> ) 0)
      [
        Q.compare p.x r.x;
        Q.compare p.y r.y;
        Q.compare q.x s.x;
        Q.compare q.y s.y;
      ]
    |> Option.value ~default:0
  in
  List.length sides = List.length (List.sort_uniq order sides)

let scale_by k (p : Point.t) =
  Point.v (Float.ldexp p.x k) (Float.ldexp p.y k) (Float.ldexp p.z k)

let scaled_triangle k (t : Triangle.t) =
  let { Triangle.a; b; c } = t.corners in
  { Triangle.a = scale_by k a; b = scale_by k b; c = scale_by k c }

let scale_law =
  law ~count:60 "a power of two scales the triangles and changes nothing else"
    wild
  @@ fun outline ->
  let corners = List.map point outline in
  let at k =
    match Polygon.make (List.map (scale_by k) corners) with
    | Ok polygon -> List.map (scaled_triangle (-k)) polygon.triangles
    | Error _ -> []
  in
  let same k = List.equal Triangle.equal_corners (at k) (at 0) in
  List.for_all same [ -200; -37; 1; 64; 200 ]

(* A turn by a matrix whose rows are orthogonal and three long: exact. *)
let turned (x, y) =
  let x = float_of_int x and y = float_of_int y in
  Point.v
    (x +. (2. *. y) +. 5.)
    ((2. *. x) +. y -. 7.)
    ((2. *. x) -. (2. *. y) +. 11.)

let unturned (p : Point.t) =
  let x = Q.of_float (p.x -. 5.)
  and y = Q.of_float (p.y +. 7.)
  and z = Q.of_float (p.z -. 11.) in
  let ninth k q = Q.div (Q.mul (Q.of_int k) q) (Q.of_int 9) in
  {
    x = sum [ ninth 1 x; ninth 2 y; ninth 2 z ];
    y = sum [ ninth 2 x; ninth 1 y; ninth (-2) z ];
  }

let tilted outline =
  let back (t : Triangle.t) =
    let { Triangle.a; b; c } = t.corners in
    (unturned a, unturned b, unturned c)
  in
  List.map back (made (List.map turned outline))

let tilt_law =
  law "a tilted polygon is filled like a level one" star_shaped
  @@ fun outline -> fills_exactly outline (tilted outline)

let tilted_tangle_law =
  law "a tilted tangle is filled like a level one" tangle @@ fun outline ->
  let triangles =
    if List.is_empty (maybe_filled outline) then [] else tilted outline
  in
  fills outline samples triangles

let ring_law =
  let turn_by k outline =
    List.mapi
      (fun i _ -> List.nth outline ((i + k) mod List.length outline))
      outline
  in
  law "the first corner and the way round change no area" tangle
  @@ fun outline ->
  let size outline = Q.abs (area (maybe_filled outline)) in
  let whole = size outline in
  close_to whole (size (turn_by 2 outline))
  && close_to whole (size (List.rev outline))

let test_thin () =
  let along t h = Point.v (t +. h) ((0.7 *. t) -. h) ((0.3 *. t) +. h) in
  List.iter
    (fun h ->
      let corners = [ along 0. 0.; along 1. 0.; along 1. h; along 0.4 h ] in
      Alcotest.(check int) "triangles" 2 (List.length (made corners)))
    [ 0x1p-10; 0x1p-20; 0x1p-30; 0x1p-40 ]

let test_far () =
  let far (x, y) = Point.v (0x1p40 +. float_of_int x) (float_of_int y) 0.1 in
  Alcotest.(check int) "triangles" 8 (List.length (made (List.map far keyhole)));
  let tiny (x, y) = Point.v (float_of_int x) (0x1p-500 *. float_of_int y) 0. in
  ignore (Polygon.make (List.map tiny pentagram));
  let uneven i (x, y) =
    let k = (i * 271 mod 800) - 400 in
    Point.v
      (Float.ldexp (float_of_int x /. 100.) k)
      (Float.ldexp (float_of_int y /. 100.) (-k))
      0.
  in
  ignore (Polygon.make (List.mapi uneven (pentagram @ keyhole @ bow_tie)))

let test_exact () =
  let ulps i = 0.5 +. (0x1p-53 *. float_of_int i) in
  for i = 0 to 15 do
    for j = 0 to 15 do
      let a = Point.v (ulps i) (ulps j) 0. in
      let corners = [ a; point (12, 12); point (24, 24) ] in
      let way = turn (level a) (spot (12, 12)) (spot (24, 24)) in
      match Polygon.make corners with
      | Ok { triangles = [ t ]; _ } ->
          Alcotest.(check int) "facing" way (Q.sign (double_area (spots t)))
      | Ok _ -> Alcotest.fail "more than one triangle"
      | Error _ -> Alcotest.(check int) "on one line" 0 way
    done
  done

let test_tilted_bow_tie () =
  let tilt (x, y) =
    let x = 0.1 *. float_of_int x and y = 0.1 *. float_of_int y in
    Point.v (x +. (0.3 *. y)) ((0.7 *. x) -. y) ((0.9 *. y) -. (1.1 *. x))
  in
  let triangles = made (List.map tilt [ (0, 0); (7, 7); (7, 0); (0, 7) ]) in
  Alcotest.(check int) "triangles" 2 (List.length triangles)

(* Sides that differ by rounding errors and cross each other all along. *)
let strand =
  QCheck2.Gen.(
    list_size (int_range 3 24) (pair (int_range 0 20) (int_range 0 2)))

let strand_law =
  law "sides too close to tell apart still end in triangles" strand
  @@ fun outline ->
  let corner (t, noise) =
    let t = float_of_int t in
    Point.v ((t /. 7.) +. (0x1p-52 *. float_of_int noise)) (t /. 3.) 0.
  in
  let corners = List.map corner outline in
  match Polygon.make corners with
  | Error _ -> true
  | Ok { triangles; _ } ->
      let wanted = true_area (List.map level corners) in
      let got = Q.abs (area (List.map spots triangles)) in
      Q.lt (Q.abs (Q.sub wanted got)) (Q.of_float 0x1p-46)

let case name f = Alcotest.test_case name `Quick f

let suite =
  ( "polygon",
    List.map test_known known @ List.map test_many many
    @ [
        case "a pentagram is filled at its centre too" test_pentagram;
        case "triangles face the way the outline runs round most" test_facing;
        case "what has no area is refused" test_degenerate;
        case "what reaches too far is refused" test_reach;
        case "the corner off the plane is named" test_plane;
        case "a thin tilted polygon is flat" test_thin;
        case "a corner beside a line is told from one on it" test_exact;
        case "a tilted bow-tie is flat" test_tilted_bow_tie;
        case "corners of unlike size are no trouble" test_far;
        star_law;
        tangle_law;
        wild_law;
        corners_law;
        scale_law;
        tilt_law;
        tilted_tangle_law;
        strand_law;
        ring_law;
      ] )
