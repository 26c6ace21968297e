open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2
module Tree = Candor_surface.Tree

let pack boxes =
  let flat = Box_array.create (Array.length boxes) in
  Array.iteri (Box_array.set flat) boxes;
  flat

let build_of boxes items = Tree.build (pack boxes) (Array.copy items)
let places boxes = Array.init (Array.length boxes) Fun.id
let build boxes = build_of boxes (places boxes)

(* {1 A tree as its links tell} *)

type node =
  | Leaf of { box : Bounds.t; first : int; count : int }
  | Inner of { box : Bounds.t; axis : int; low : node; high : node }

(* And the number after the last one of its nodes. *)
let rec read (t : Tree.t) n =
  let box = Box_array.get t.boxes n and link = t.links.(n) in
  if Tree.is_leaf link then
    (Leaf { box; first = Tree.first link; count = Tree.count link }, n + 1)
  else
    let low, next = read t (n + 1) in
    let high_child = Tree.high_child link in
    if high_child <> next then Law.fail "node %d is not where it should be" next;
    let high, next = read t high_child in
    (Inner { box; axis = Tree.axis link; low; high }, next)

let root t =
  let root, size = read t 0 in
  if size <> Array.length t.links then Law.fail "not every node is reached";
  root

let rec depth = function
  | Leaf _ -> 0
  | Inner { low; high; _ } -> 1 + Int.max (depth low) (depth high)

let rec leaves = function
  | Leaf { first; count; _ } -> [ (first, count) ]
  | Inner { low; high; _ } -> leaves low @ leaves high

let box = function Leaf { box; _ } | Inner { box; _ } -> box

let items (t : Tree.t) node =
  let of_leaf (first, count) = Array.to_list (Array.sub t.order first count) in
  List.concat_map of_leaf (leaves node)

(* {1 What every tree must be} *)

let holds outer inner = Bounds.equal (Bounds.join outer inner) outer

let rec fits boxes (t : Tree.t) node =
  let least =
    List.fold_left
      (fun b i -> Bounds.join b boxes.(i))
      Bounds.empty (items t node)
  in
  Bounds.equal (box node) least
  &&
  match node with
  | Leaf _ -> true
  | Inner { box = outer; low; high; _ } ->
      holds outer (box low)
      && holds outer (box high)
      && fits boxes t low && fits boxes t high

let rec axes_are_axes = function
  | Leaf _ -> true
  | Inner { axis; low; high; _ } ->
      0 <= axis && axis <= 2 && axes_are_axes low && axes_are_axes high

(* Leaf after leaf, without gap, and each of some items. *)
let leaves_cover n node =
  let next =
    List.fold_left
      (fun next (first, count) ->
        if first <> next then Law.fail "a leaf begins at %d, not %d" first next;
        if count < 1 || count > 15 then Law.fail "a leaf of %d items" count;
        first + count)
      0 (leaves node)
  in
  next = n

let not_too_deep n node =
  let most = 40. +. Float.log2 (float_of_int n) in
  let deepest = depth node in
  float_of_int deepest <= most || Law.fail "a path of length %d" deepest

(* No root is open and no node of a large tree; open ones fill what they are
   in. *)
let open_nodes_are_large (boxes, items) =
  let t = build_of boxes items in
  let area n =
    let b = Box_array.get t.boxes n in
    let d = Point.sub (Bounds.high b) (Bounds.low b) in
    (d.x *. d.y) +. (d.y *. d.z) +. (d.z *. d.x)
  in
  let rec sound n around =
    let link = t.links.(n) in
    Tree.is_leaf link
    ||
    let is_open = Tree.is_open link in
    ((not is_open)
    || Tree.may_be_open t && n <> around
       && not (area n < 0.5999 *. area around))
    &&
    let around = if is_open then around else n in
    sound (n + 1) around && sound (Tree.high_child link) around
  in
  Array.length t.links = 0 || sound 0 0

let room () =
  let wall i = Bounds.v Point.origin (Point.v 9. 9. (9. +. float_of_int i)) in
  let opened n =
    let links = (build (Array.init n wall)).links in
    let is_open l = (not (Tree.is_leaf l)) && Tree.is_open l in
    Array.exists is_open links
  in
  Alcotest.(check bool) "among few" true (opened 16);
  Alcotest.(check bool) "among many" false (opened 40)

let sorted a = List.sort Int.compare (Array.to_list a)

let is_sound (boxes, items) =
  let t = build_of boxes items in
  let n = Array.length items in
  List.equal Int.equal (sorted items) (sorted t.order)
  &&
  if n = 0 then Array.length t.links = 0
  else
    let node = root t in
    (leaves_cover n node || Law.fail "items are missing")
    && (fits boxes t node || Law.fail "a box is not that of its items")
    && (axes_are_axes node || Law.fail "there is no such axis")
    && not_too_deep n node

let same_again (boxes, items) =
  let a = build_of boxes items and b = build_of boxes items in
  a.links = b.links && a.order = b.order
  && List.for_all
       (fun n ->
         Bounds.equal (Box_array.get a.boxes n) (Box_array.get b.boxes n))
       (List.init (Array.length a.links) Fun.id)

(* Where centres differ, what is low on the axis goes to the low child. *)
let divided_by_axis (boxes, items') =
  let flat = pack boxes in
  let t = build_of boxes items' in
  let centers axis node =
    List.map (fun i -> Box_array.center flat i axis) (items t node)
  in
  let rec divided = function
    | Leaf _ -> true
    | Inner { axis; low; high; _ } ->
        let top = List.fold_left Float.max neg_infinity (centers axis low)
        and bottom = List.fold_left Float.min infinity (centers axis high) in
        top <= bottom && divided low && divided high
  in
  divided (root t)

(* {1 Boxes} *)

let box_at (a : Point.t) (size : Vec.t) =
  Bounds.of_points [ a; Point.add a size ]

let around number size = Gen.map2 box_at (Draw.point number) (Draw.vec size)
let scattered = around (Draw.uniform (-9.) 9.) (Draw.uniform 0. 1.)

(* Boxes at r^i: the more they crowd the deeper one has to look. *)
let dwindling =
  let open Gen in
  let* r = Draw.pick [ 0.5; 0.7; 0.1; 0x1p-5 ] and* s = Draw.sign in
  let* n = int_range 1 150 and* share = Draw.pick [ 0.; 0.125; 1. ] in
  let at i =
    let x = r ** float_of_int i in
    box_at (Point.v (s *. x) x 0.) (Vec.v (share *. x) 0. (share *. x))
  in
  return (Array.init n at)

let boxes =
  let open Gen in
  let many box = array_size (int_bound 120) box in
  let whole = Draw.small 3 in
  oneof
    [
      many scattered;
      many (around whole (Gen.map Float.abs whole));
      many (around Draw.any_coordinate (Gen.map Float.abs Draw.any_coordinate));
      (let* b = around whole whole and* n = int_bound 200 in
       return (Array.make n b));
      (let* few = array_size (int_range 1 3) (around whole whole) in
       many (oneof_array few));
      (* About one centre. *)
      many
        (map
           (fun r ->
             let r = Float.abs r in
             Bounds.v (Point.v (-.r) (-.r) (-.r)) (Point.v r r r))
           Draw.coordinate);
      (* Nearer to each other than bins can tell, and too far apart. *)
      many (around (Draw.pick [ 0.; 5e-324; 1e-310 ]) (return 0.));
      many (around (Draw.pick [ 0.; -1e308; 1e308 ]) (return 0.));
      dwindling;
    ]

let some_of boxes =
  let open Gen in
  let+ order = shuffle_list (Array.to_list (places boxes))
  and+ share = Draw.pick [ 1; 1; 2 ] in
  let n = Array.length boxes / share in
  (boxes, Array.of_list (List.filteri (fun i _ -> i < n) order))

let cases = Gen.(boxes >>= some_of)
let spread_cases = Gen.(array_size (int_range 2 200) scattered >>= some_of)

let show (boxes, items) =
  String.concat "\n"
    (Array.to_list
       (Array.map
          (fun i -> Printf.sprintf "%d: %s" i (Bounds.show boxes.(i)))
          items))

(* {1 Known ones} *)

let path_of boxes =
  let t = build boxes in
  let node = root t in
  Alcotest.(check bool)
    "every item is in a leaf" true
    (leaves_cover (Array.length boxes) node);
  depth node

let unit = Bounds.v Point.origin (Point.v 1. 1. 1.)

let check_path boxes =
  let deepest = path_of boxes in
  let most = 40. +. Float.log2 (float_of_int (Array.length boxes)) in
  Alcotest.(check bool)
    (Printf.sprintf "%d" deepest)
    true
    (float_of_int deepest <= most)

let identical () =
  let deepest = path_of (Array.make 10_000 unit) in
  Alcotest.(check bool) (string_of_int deepest) true (deepest <= 14)

(* On one side always few, on the other the rest: halving space is no way out. *)
let crowding () =
  List.iter
    (fun k ->
      let at i = Float.ldexp 1. (-(i * k)) in
      let n = 1000 / k in
      check_path
        (Array.init n (fun i ->
             box_at (Point.v (at i) 0. 0.) (Vec.v (at i /. 8.) 0. 0.))))
    [ 1; 2; 3; 5; 8 ]

let none_and_one () =
  Alcotest.(check int) "no node" 0 (Array.length (build [||]).links);
  let t = build [| unit |] in
  Alcotest.(check int) "one node" 1 (Array.length t.links);
  Alcotest.(check bool) "a leaf" true (Tree.is_leaf t.links.(0));
  Alcotest.(check int) "of one" 1 (Tree.count t.links.(0));
  Alcotest.(check bool)
    "its box" true
    (Bounds.equal unit (Box_array.get t.boxes 0))

let two_clusters () =
  let at i =
    let x = if i mod 2 = 0 then 0. else 100. in
    box_at (Point.v 0. (x +. float_of_int i) 0.) (Vec.v 1. 1. 1.)
  in
  let t = build (Array.init 20 at) in
  match root t with
  | Leaf _ -> Alcotest.fail "one leaf"
  | Inner { axis; low; high; _ } ->
      let parity n node = List.for_all (fun i -> i mod 2 = n) (items t node) in
      Alcotest.(check int) "divided along" 1 axis;
      Alcotest.(check bool) "the near one" true (parity 0 low);
      Alcotest.(check bool) "the far one" true (parity 1 high)

let law ?count name gen holds = Law.law ?count ~print:show name gen holds

let suite =
  ( "tree",
    [
      law ~count:800
        "every item is in one leaf, and every node's box is the least that \
         holds its items"
        cases is_sound;
      law ~count:200 "the same boxes make the same tree" cases same_again;
      law ~count:200 "an inner node is divided along its axis" spread_cases
        divided_by_axis;
      law ~count:400 "open nodes fill the closed ones that they are in" cases
        open_nodes_are_large;
      Law.example "boxes around the same room are open" room;
      Law.example "of nothing there is no node, of one item a leaf" none_and_one;
      Law.example "two clusters are parted" two_clusters;
      Law.example "G5: identical boxes are divided by number" identical;
      Law.example "G5: boxes that crowd to a point make no long paths" crowding;
    ] )
