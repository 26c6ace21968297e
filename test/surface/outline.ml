(** Outlines of polygons on the plane, in exact numbers: what they enclose, what
    the triangles of a filled one must be, and outlines with known areas. *)

open Candor_space
open Candor_surface

(* {1 Exact plane geometry} *)

type spot = { x : Q.t; y : Q.t }

let spot (x, y) = { x = Q.of_int x; y = Q.of_int y }
let equal p q = Q.equal p.x q.x && Q.equal p.y q.y

let cross p q r =
  Q.sub
    (Q.mul (Q.sub q.x p.x) (Q.sub r.y p.y))
    (Q.mul (Q.sub q.y p.y) (Q.sub r.x p.x))

let turn p q r = Q.sign (cross p q r)
let half = Q.of_ints 1 2
let sum = List.fold_left Q.add Q.zero

let sides = function
  | [] -> []
  | first :: rest as all -> List.combine all (rest @ [ first ])

let shoelace outline =
  let origin = spot (0, 0) in
  let swept (p, q) = cross origin p q in
  Q.mul half (sum (List.map swept (sides outline)))

let within (p, q) r =
  turn p q r = 0
  && Q.leq (Q.min p.x q.x) r.x
  && Q.leq r.x (Q.max p.x q.x)
  && Q.leq (Q.min p.y q.y) r.y
  && Q.leq r.y (Q.max p.y q.y)

let on_outline outline r =
  List.exists (fun side -> within side r) (sides outline)

(* How often the outline winds around a point that is not on it. *)
let winding outline r =
  let pass (p, q) =
    let from_below = Q.leq p.y r.y and to_below = Q.leq q.y r.y in
    if from_below && (not to_below) && turn p q r > 0 then 1
    else if (not from_below) && to_below && turn p q r < 0 then -1
    else 0
  in
  List.fold_left (fun n side -> n + pass side) 0 (sides outline)

let height_at x (p, q) =
  let slope = Q.div (Q.sub q.y p.y) (Q.sub q.x p.x) in
  Q.add p.y (Q.mul slope (Q.sub x p.x))

let crossing_x (p, q) (r, s) =
  let d = Q.sub (cross p q s) (cross p q r) in
  if Q.sign d = 0 then None
  else
    let t = Q.div (Q.neg (cross p q r)) d in
    if Q.sign t < 0 || Q.gt t Q.one then None
    else Some (Q.add r.x (Q.mul t (Q.sub s.x r.x)))

(* The area that the outline winds around, by slabs in which no two sides cross:
   an independent oracle, of cubic cost. *)
let slab outline left right =
  let mid = Q.mul half (Q.add left right) in
  let spans (p, q) = Q.lt (Q.min p.x q.x) mid && Q.gt (Q.max p.x q.x) mid in
  let height ((p, q) as side) =
    (height_at mid side, if Q.lt p.x q.x then 1 else -1)
  in
  let heights = List.map height (List.filter spans (sides outline)) in
  let sorted = List.sort (fun (a, _) (b, _) -> Q.compare a b) heights in
  let step (tall, low, n) (y, way) =
    let tall = if n = 0 then tall else Q.add tall (Q.sub y low) in
    (tall, y, n + way)
  in
  let tall, _, _ = List.fold_left step (Q.zero, Q.zero, 0) sorted in
  Q.mul tall (Q.sub right left)

let true_area outline =
  let sides = sides outline in
  let crossings =
    List.concat_map (fun e -> List.filter_map (crossing_x e) sides) sides
  in
  let xs = List.map (fun p -> p.x) outline @ crossings in
  let rec slabs = function
    | a :: (b :: _ as rest) -> Q.add (slab outline a b) (slabs rest)
    | [] | [ _ ] -> Q.zero
  in
  slabs (List.sort_uniq Q.compare xs)

(* {1 Polygons on planes} *)

let point (x, y) = Point.v (float_of_int x) (float_of_int y) 0.

let made corners =
  match Polygon.make corners with
  | Ok polygon -> polygon.triangles
  | Error why -> Alcotest.fail why

let level (p : Point.t) = { x = Q.of_float p.x; y = Q.of_float p.y }

let spots (t : Triangle.t) =
  let { Triangle.a; b; c } = t.corners in
  (level a, level b, level c)

let filled outline = List.map spots (made (List.map point outline))
let double_area (a, b, c) = cross a b c
let area triangles = Q.mul half (sum (List.map double_area triangles))
let q = Alcotest.testable Q.pp_print Q.equal
let check_q = Alcotest.check q

let close_to wanted got =
  let off = Q.abs (Q.sub wanted got) in
  Q.leq off (Q.mul (Q.abs wanted) (Q.of_float 0x1p-44))

let holds (a, b, c) p =
  let same s = turn a b p = s && turn b c p = s && turn c a p = s in
  same 1 || same (-1)

let touches (a, b, c) p = List.exists (fun s -> within s p) (sides [ a; b; c ])

(* {1 What every polygon must do} *)

let triangle_sides triangles =
  List.concat_map (fun (a, b, c) -> sides [ a; b; c ]) triangles

let corners_of triangles =
  let order p q =
    match Q.compare p.x q.x with 0 -> Q.compare p.y q.y | order -> order
  in
  List.sort_uniq order
    (List.concat_map (fun (a, b, c) -> [ a; b; c ]) triangles)

let sealed triangles =
  let corners = corners_of triangles in
  let whole (p, q) =
    let inside r = within (p, q) r && not (equal p r || equal q r) in
    not (List.exists inside corners)
  in
  List.for_all whole (triangle_sides triangles)

let covers outline triangles p =
  let within = List.length (List.filter (fun t -> holds t p) triangles) in
  within = if winding outline p = 0 then 0 else 1

let grid n =
  let ticks = List.init (2 * n) (fun i -> Q.of_ints ((2 * (i - n)) + 1) 2) in
  List.concat_map (fun x -> List.map (fun y -> { x; y }) ticks) ticks

let covers_all outline triangles points =
  let clear p =
    not (on_outline outline p || List.exists (fun t -> touches t p) triangles)
  in
  List.for_all (covers outline triangles) (List.filter clear points)

let same_way triangles =
  match List.map (fun t -> Q.sign (double_area t)) triangles with
  | [] -> false
  | first :: rest -> first <> 0 && List.for_all (Int.equal first) rest

(* {1 Known polygons} *)

let comb teeth =
  let tooth i = [ ((2 * i) + 1, 1); (2 * i, 10) ] in
  [ (0, 0); (2 * teeth, 0); (2 * teeth, 10) ]
  @ List.concat (List.rev (List.init teeth tooth))

(* Out on a square spiral of corridors one wide, and back on its other wall. *)
let spiral turns =
  let corner d i =
    let r = (4 * (i / 4)) + 4 + d in
    match i mod 4 with
    | 0 -> (r, r)
    | 1 -> (-r, r)
    | 2 -> (-r, -r)
    | _ -> (r + 4, -r)
  in
  let wall d = List.init (4 * turns) (corner d) in
  wall 1 @ List.rev (wall 0)

let star points =
  let corner i =
    let radius = if i mod 2 = 0 then 1e6 else 4e5 in
    let angle = Float.pi *. float_of_int i /. float_of_int points in
    ( Float.to_int (radius *. Float.cos angle),
      Float.to_int (radius *. Float.sin angle) )
  in
  List.init (2 * points) corner

let square = [ (0, 0); (4, 0); (4, 4); (0, 4) ]
let pentagram = [ (0, 100); (-59, -81); (95, 31); (-95, 31); (59, -81) ]
let bow_tie = [ (0, 0); (4, 4); (4, 0); (0, 4) ]

let keyhole =
  [ (0, 0); (9, 0); (9, 9); (0, 9); (0, 0) ]
  @ [ (3, 3); (3, 6); (6, 6); (6, 3); (3, 3) ]

(* name, outline, area, triangles *)
let known =
  let area n = Q.of_int n in
  [
    ("a square", square, area 16, 2);
    ("a clockwise square", List.rev square, area 16, 2);
    ("an L", [ (0, 0); (4, 0); (4, 1); (1, 1); (1, 4); (0, 4) ], area 7, 4);
    ("a comb", comb 30, area 330, 61);
    ("a spiral", spiral 3, shoelace (List.map spot (spiral 3)), 22);
    ("a keyhole", keyhole, area 72, 8);
    ("a square run through twice", square @ square, area 16, 2);
    ( "a square with repeated and needless corners",
      [ (0, 0); (0, 0); (2, 0); (4, 0); (4, 4); (4, 4); (4, 4); (0, 4) ],
      area 16,
      3 );
    ( "a square with a spike out and one in",
      [ (0, 0); (4, 0); (9, 0); (4, 0); (4, 4); (2, 2); (4, 4); (0, 4) ],
      area 16,
      2 );
    ( "two squares that share a corner",
      [ (0, 0); (2, 0); (2, 2); (4, 2); (4, 4); (2, 4); (2, 2); (0, 2) ],
      area 8,
      4 );
    ( "a hole that touches the outline",
      [ (0, 0); (8, 0); (8, 8); (0, 8); (0, 0); (3, 4); (4, 4); (4, 3) ],
      area 60,
      6 );
    ( "a corner that rests on a far side",
      [ (0, 0); (8, 0); (8, 8); (4, 0); (0, 8) ],
      area 32,
      2 );
    ("a bow-tie with equal halves", bow_tie, area 8, 2);
    ( "a bow-tie with one half larger",
      [ (0, 0); (9, 9); (9, 0); (0, 9); (-3, 9); (-3, 0) ],
      Q.of_ints 135 2,
      4 );
    ( "a loop that overlaps itself",
      [ (0, 0); (6, 0); (6, 6); (2, 6); (2, 2); (8, 2); (8, 8); (0, 8) ],
      area 60,
      4 );
    ( "a hole wound the same way is no hole",
      [ (0, 0); (9, 0); (9, 9); (0, 9); (0, 0) ]
      @ [ (3, 3); (6, 3); (6, 6); (3, 6); (3, 3) ],
      area 81,
      2 );
  ]
