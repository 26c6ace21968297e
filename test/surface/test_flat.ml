open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2

let qu (a : Flat.t) = Exact.q a.u
let qv (a : Flat.t) = Exact.q a.v

(* {1 Seeing} *)

(* The coordinates that are seen along an axis: the next two. *)
let across axis p =
  (Point.get p ((axis + 1) mod 3), Point.get p ((axis + 2) mod 3))

let axis = Gen.int_bound 2

let number =
  Gen.oneof
    [
      Draw.small 4;
      Draw.uniform (-9.) 9.;
      Draw.any_coordinate;
      Draw.signed (Draw.power (-700) 400);
    ]

let points = Gen.(list_size (int_range 1 6) (Draw.point number))

let show_points (axis, points) =
  Printf.sprintf "along %d: %s" axis
    (String.concat " " (List.map Draw.show_point points))

(* By a power of two that brings the largest to 1/2..1; what is tiny is 0. *)
let seen_as (axis, points) =
  let view = Flat.view ~axis points in
  let coordinate get p = Float.abs (get (across axis p)) in
  let largest get =
    List.fold_left (fun m p -> Float.max m (coordinate get p)) 0. points
  in
  let is_seen get seen p =
    let k = snd (Float.frexp (largest get)) in
    let wanted = Exact.(q (get (across axis p)) / power k) in
    let wanted =
      if Q.lt (Q.abs wanted) (Exact.power (-450)) then Q.zero else wanted
    in
    Q.equal wanted (Exact.q seen) && Float.abs seen <= 1.
  in
  List.for_all
    (fun p ->
      let a = Flat.see view p in
      is_seen fst a.u p && is_seen snd a.v p && Point.equal a.place p)
    points

(* The component of the exact cross product that points to the viewer. *)
let true_turn axis a b c =
  let away b = Exact.(sub (point b) (point a)) in
  let n = Exact.cross (away b) (away c) in
  Q.sign (match axis with 0 -> n.x | 1 -> n.y | _ -> n.z)

let turns_as_in_space (axis, (p, q, r)) =
  let see = Flat.see (Flat.view ~axis [ p; q; r ]) in
  let found = Flat.turn (see p) (see q) (see r)
  and wanted = true_turn axis p q r in
  found = wanted || Law.fail "found %d, the truth is %d" found wanted

let whole = Draw.point (Draw.small 3)

(* The third almost or exactly on the line through the other two. *)
let nearly_collinear =
  let open Gen in
  let* p = Draw.point (Draw.uniform (-2.) 2.)
  and* q = Draw.point (oneof [ Draw.small 4; Draw.uniform (-2.) 2. ])
  and* t =
    oneof [ Draw.uniform (-1.) 2.; Draw.pick [ 0.; 1.; 0.5; 2.; 0x1p-30 ] ]
  in
  let r = Draw.move p (Draw.toward p q) t in
  let* x = Draw.nudged (return r.x)
  and* y = Draw.nudged (return r.y)
  and* z = Draw.nudged (return r.z)
  and* k = Draw.either 50 (return 0) (int_range (-300) 300) in
  let at (p : Point.t) =
    Point.v (Float.ldexp p.x k) (Float.ldexp p.y k) (Float.ldexp p.z k)
  in
  return (at p, at q, at (Point.v x y z))

(* {1 Deciding} *)

(* Seen along z, by numbers below 1 that are kept as they are. *)
let level = Flat.view ~axis:2 [ Point.v 0.75 0.75 0. ]
let spot ?(z = 0.) x y = Flat.see level (Point.v x y z)

let near_one =
  Gen.oneof [ Draw.uniform (-1.) 1.; Gen.map (( *. ) 0.25) (Draw.small 4) ]

let any_spot =
  Gen.map2
    (fun x y -> spot x y)
    (Gen.oneof [ near_one; Draw.signed (Draw.power (-600) 0) ])
    (Gen.oneof [ near_one; Draw.signed (Draw.power (-600) 0) ])

let show_spot (a : Flat.t) = Printf.sprintf "(%h, %h)" a.u a.v
let show_spots spots = String.concat " " (List.map show_spot spots)

let swept a b c =
  Exact.(((qu b - qu a) * (qv c - qv a)) - ((qv b - qv a) * (qu c - qu a)))

let turns_as_seen (a, b, c) =
  let way = Flat.turn a b c in
  way = Q.sign (swept a b c) && way = Flat.turn b c a && way = -Flat.turn b a c

let ordered (a, b) =
  let wanted =
    match Q.compare (qu a) (qu b) with
    | 0 -> Q.compare (qv a) (qv b)
    | order -> order
  in
  let found = Flat.compare a b in
  Int.compare found 0 = Int.compare wanted 0 && Flat.equal a b = (wanted = 0)

let place_is_unseen () =
  let a = spot 0.5 0.25 and b = spot ~z:9. 0.5 0.25 in
  Alcotest.(check bool) "equal" true (Flat.equal a b);
  Alcotest.(check bool) "places" false (Point.equal a.place b.place);
  Alcotest.(check bool) "zeros" true (Flat.equal (spot 0. 0.5) (spot (-0.) 0.5))

let outline =
  Gen.(list_size (int_bound 8) (pair (int_range (-4) 4) (int_range (-4) 4)))

(* In whole numbers. *)
let faces outline =
  let seen (i, j) = spot (float_of_int i /. 8.) (float_of_int j /. 8.) in
  let wanted =
    match outline with
    | [] -> 0
    | (x, y) :: rest ->
        let sweep (a, b) (c, d) = ((a - x) * (d - y)) - ((b - y) * (c - x)) in
        let rec sweeps = function
          | p :: (q :: _ as rest) -> sweep p q :: sweeps rest
          | [] | [ _ ] -> []
        in
        let all = sweeps rest in
        let total = List.fold_left ( + ) 0 all in
        let first = List.find_opt (( <> ) 0) all in
        if total <> 0 then Int.compare total 0
        else Int.compare (Option.value first ~default:0) 0
  in
  let found = Flat.facing (List.map seen outline) in
  found = wanted || Law.fail "found %d, the truth is %d" found wanted

(* {1 The grid} *)

let width = Exact.power (-53)
let half_width = Exact.power (-54)
let on_grid x = Z.equal (Q.den Exact.(x / width)) Z.one

(* The square of a point of the grid is open above and on the right. *)
let in_square p x y =
  let within at x =
    Q.leq Exact.(at - half_width) x && Q.lt x Exact.(at + half_width)
  in
  within (qu p) x && within (qv p) y

let grid_number =
  Gen.oneof
    [
      near_one;
      Draw.uniform (-0x1p-40) 0x1p-40;
      Draw.nudged (Gen.map (fun k -> k *. 0x1p-54) (Draw.small 9));
      Draw.nudged (Gen.map (fun k -> 0.25 +. (k *. 0x1p-54)) (Draw.small 9));
      Draw.signed (Draw.power (-200) (-50));
    ]

let to_grid (x, y) =
  let a = spot ~z:7. x y in
  let b = Flat.to_grid a in
  on_grid (qu b)
  && on_grid (qv b)
  && in_square b (qu a) (qv a)
  && Point.equal a.place b.place
  && Flat.equal b (Flat.to_grid b)

let steps k = float_of_int k *. 0x1p-53

(* On the grid: near each other in the middle, or anywhere. *)
let grid_spot =
  let open Gen in
  let near = map steps (int_range (-8) 8) in
  let middling = map (fun k -> 0.25 +. steps k) (int_range (-6) 6) in
  let any =
    map steps (int_range (-0x1p53 |> int_of_float) (int_of_float 0x1p53))
  in
  let pair x = map3 (fun x y z -> spot ~z x y) x x (Draw.small 4) in
  oneof [ pair near; pair near; pair middling; pair any ]

let segment =
  Gen.(
    let+ a = grid_spot and+ b = grid_spot in
    match Flat.compare a b with
    | 0 -> (spot (-1.) a.v, spot 1. a.v)
    | order -> if order < 0 then (a, b) else (b, a))

(* Where on a segment the coordinate is in low <= x < high: open ends are told
   from closed ones by a second component, an infinitesimal. *)
let span from until at =
  let low = Exact.(at - half_width) and high = Exact.(at + half_width) in
  let d = Exact.(until - from) in
  match Q.sign d with
  | 0 ->
      if Q.leq low from && Q.lt from high then Some ((Q.zero, 0), (Q.one, 0))
      else None
  | s ->
      let t x = Exact.((x - from) / d) in
      if s > 0 then Some ((t low, 0), (t high, -1))
      else Some ((t high, 1), (t low, 0))

let order (x, i) (y, j) =
  match Q.compare x y with 0 -> Int.compare i j | order -> order

let later x y = if order x y >= 0 then x else y
let sooner x y = if order x y <= 0 then x else y

let truly_enters (a, b) p =
  match (span (qu a) (qu b) (qu p), span (qv a) (qv b) (qv p)) with
  | Some (low, high), Some (low', high') ->
      let low = later (Q.zero, 0) (later low low')
      and high = sooner (Q.one, 0) (sooner high high') in
      order low high <= 0
  | _ -> false

(* A point of the grid within the u of the segment, and near it. *)
let beside (((a : Flat.t), (b : Flat.t)) as s) =
  let open Gen in
  let+ t = oneof [ Draw.uniform 0. 1.; Draw.pick [ 0.; 0.5; 1. ] ]
  and+ i = int_range (-2) 2
  and+ j = int_range (-2) 2 in
  let mix x y = x +. (t *. (y -. x)) in
  let on x = (Flat.to_grid (spot x 0.)).u in
  let x = on (mix a.u b.u) +. steps i and y = on (mix a.v b.v) +. steps j in
  (s, Flat.to_grid (spot (Float.max a.u (Float.min b.u x)) y))

let segment_and_spot =
  Gen.(
    let* s = segment in
    beside s)

let enters (s, p) =
  let found = Flat.enters s p and wanted = truly_enters s p in
  found = wanted || Law.fail "found %b, the truth is %b" found wanted

(* {1 Crossings} *)

let opposite s a b =
  Flat.turn (fst s) (snd s) a * Flat.turn (fst s) (snd s) b < 0

let crossing_pair =
  Gen.(
    let* ((a, b) as s) = segment in
    let* c = grid_spot and* d = grid_spot and* mirrored = bool in
    (* Through the middle of the first, more often than not. *)
    let mirror (c : Flat.t) =
      spot
        (Float.max (-1.) (Float.min 1. (a.u +. b.u -. c.u)))
        (Float.max (-1.) (Float.min 1. (a.v +. b.v -. c.v)))
    in
    return (s, (c, if mirrored then Flat.to_grid (mirror c) else d)))

let true_crossing (a, b) (c, d) =
  let near = swept c d a and far = swept c d b in
  let t = Exact.(near / (near - far)) in
  let at x y = Exact.(x + (t * (y - x))) in
  (t, at (qu a) (qu b), at (qv a) (qv b))

let do_cross ((a, b) as s) ((c, d) as r) = opposite s c d && opposite r a b

(* The quotient is rounded before it is brought to the grid: near a tie the
   other neighbour may be taken. *)
let crosses ((((a : Flat.t), (b : Flat.t)) as s), r) =
  (not (do_cross s r))
  ||
  let p = Flat.crossing level s r in
  let t, x, y = true_crossing s r in
  let near x y =
    let rounded = Exact.(half_width + (power (-51) * Q.abs y)) in
    Q.leq (Q.abs (Q.sub x y)) (Q.min width rounded)
  in
  let height = Exact.(q a.place.z + (t * (q b.place.z - q a.place.z))) in
  let check what holds = holds || Law.fail "%s of %s" what (show_spot p) in
  check "off the grid" (on_grid (qu p) && on_grid (qv p))
  && check "not near the crossing" (near (qu p) x && near (qv p) y)
  && check "not at its place" (p.place.x = p.u && p.place.y = p.v)
  && check "not at its height"
       (Q.leq
          (Q.abs (Q.sub (Exact.q p.place.z) height))
          Exact.(power (-50) * q (Float.max 1. (Float.abs p.place.z))))

let show_segment (a, b) = show_spot a ^ " to " ^ show_spot b

let law ?(count = 5000) ~print name gen holds =
  Law.law ~count ~print name gen holds

let show3 (a, b, c) = show_spots [ a; b; c ]

let suite =
  ( "flat",
    [
      law ~print:show_points "what is seen is exact, near 1, and 0 where tiny"
        (Gen.pair axis points) seen_as;
      law
        ~print:(fun (axis, (p, q, r)) -> show_points (axis, [ p; q; r ]))
        "a turn is that about the axis, exactly, on whole numbers"
        Gen.(pair axis (triple whole whole whole))
        turns_as_in_space;
      law
        ~print:(fun (axis, (p, q, r)) -> show_points (axis, [ p; q; r ]))
        "a turn is that about the axis, exactly, where points almost line up"
        (Gen.pair axis nearly_collinear)
        turns_as_in_space;
      law ~print:show3 "a turn is exact as seen, whatever the sizes"
        (Gen.triple any_spot any_spot any_spot)
        turns_as_seen;
      law
        ~print:(fun (a, b) -> show_spots [ a; b ])
        "spots are ordered by u, then by v"
        Gen.(
          let* a = any_spot in
          let* b =
            oneof
              [ any_spot; return a; map (fun y -> spot a.Flat.u y) near_one ]
          in
          return (a, b))
        ordered;
      Law.example "what is seen in one spot is equal" place_is_unseen;
      law
        ~print:(fun o ->
          String.concat " "
            (List.map (fun (i, j) -> Printf.sprintf "(%d, %d)" i j) o))
        "an outline faces as its area, else as its first turn" outline faces;
      law
        ~print:(fun (x, y) -> Printf.sprintf "(%h, %h)" x y)
        "on the grid a spot is the one whose square holds it"
        (Gen.pair grid_number grid_number)
        to_grid;
      law ~count:20000
        ~print:(fun (s, p) -> show_segment s ^ " and " ^ show_spot p)
        "a segment enters a square if it meets it, open ends left out"
        segment_and_spot enters;
      law
        ~print:(fun (s, r) -> show_segment s ^ " and " ^ show_segment r)
        "a crossing is on the grid and nearest, but near a tie" crossing_pair
        crosses;
    ] )
