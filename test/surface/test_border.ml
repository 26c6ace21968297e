open Candor_space
open Candor_surface
open Outline
open Test_polygon

(* {1 Outlines of whole numbers, seen from above} *)

let view_of corners = Flat.view ~axis:2 corners

let border_of corners =
  let view = view_of corners in
  Border.of_outline view (List.map (Flat.see view) corners)

let border outline = border_of (List.map point outline)

(* What is seen, in whole numbers again. The places of corners are exact, and
   those of crossings are where they are seen. *)
let at (a : Flat.t) = level a.place
let side (e : Border.edge) = (at e.left, at e.right)

(* {1 Exact facts about edges} *)

let turn_of (e : Border.edge) p = Flat.turn e.left e.right p

let inside (e : Border.edge) p =
  turn_of e p = 0 && Flat.compare e.left p < 0 && Flat.compare p e.right < 0

let cross (e : Border.edge) (f : Border.edge) =
  turn_of e f.left * turn_of e f.right < 0
  && turn_of f e.left * turn_of f e.right < 0

let same (e : Border.edge) (f : Border.edge) =
  Flat.equal e.left f.left && Flat.equal e.right f.right

let disjoint (e : Border.edge) (f : Border.edge) =
  not
    (same e f || cross e f || inside e f.left || inside e f.right
   || inside f e.left || inside f e.right)

let rec all_pairs holds = function
  | [] -> true
  | x :: rest -> List.for_all (holds x) rest && all_pairs holds rest

let after (e : Border.edge) (f : Border.edge) =
  match Flat.compare e.left f.left with
  | 0 -> Flat.turn e.left e.right f.right > 0
  | order -> order < 0

let leftmost_first (e : Border.edge) = Flat.compare e.left e.right < 0

let well_formed edges =
  List.for_all leftmost_first edges
  && all_pairs disjoint edges && all_pairs after edges

(* {1 What a border encloses} *)

let middle (p, q) =
  { x = Q.mul half (Q.add p.x q.x); y = Q.mul half (Q.add p.y q.y) }

let upright (p, q) = Q.equal p.x q.x

(* How many sides are straight below a point that is not on one. *)
let below sides r =
  let under ((p, q) as s) =
    let spans = Q.leq (Q.min p.x q.x) r.x && Q.lt r.x (Q.max p.x q.x) in
    spans && Q.lt (height_at r.x s) r.y
  in
  List.length (List.filter under sides)

let encloses sides r = below sides r mod 2 = 1

(* By what is under each edge that is not upright: 0 or more trapezoids. *)
let enclosed_area sides =
  let under ((p, q) as s) =
    let size = Q.mul (Q.mul half (Q.add p.y q.y)) (Q.sub q.x p.x) in
    if upright s then Q.zero
    else if encloses sides (middle s) then size
    else Q.neg size
  in
  sum (List.map under sides)

(* The winding just over and just under the middle of a side, or to its left and
   right. *)
let parts outline ((p, q) as s) =
  let m = middle s and e = Q.of_float 0x1p-30 in
  let near dx dy = { x = Q.add m.x (Q.mul e dx); y = Q.add m.y (Q.mul e dy) } in
  let dx = Q.sub q.x p.x and dy = Q.sub q.y p.y in
  let wound r = winding outline r <> 0 in
  wound (near (Q.neg dy) dx) <> wound (near dy (Q.neg dx))

(* {1 Laws} *)

let winds_where outline sides r = encloses sides r = (winding outline r <> 0)

let borders_exactly outline edges =
  let exact = List.map spot outline and sides = List.map side edges in
  let corner p = List.exists (equal p) exact in
  well_formed edges
  && List.for_all (fun (p, q) -> corner p && corner q) sides
  && List.for_all (parts exact) sides
  && Q.equal (enclosed_area sides) (true_area exact)
  && List.for_all
       (fun r -> on_outline exact r || winds_where exact sides r)
       (grid 9)

(* Ends and middles are less than a width of the grid off a side, in units of
   the whole numbers. *)
let bends_little outline edges =
  let exact = Outline.sides (List.map spot outline) in
  let largest get =
    List.fold_left (fun m c -> Int.max m (Int.abs (get c))) 0 outline
  in
  let width get =
    let k = snd (Float.frexp (float_of_int (largest get))) in
    Q.of_float (Float.ldexp 1. (k - 53))
  in
  let wx = width fst and wy = width snd in
  let beside ((p, q) as s) r =
    let reach lo hi w x =
      Q.leq (Q.sub (Q.min lo hi) w) x && Q.leq x (Q.add (Q.max lo hi) w)
    in
    reach p.x q.x wx r.x && reach p.y q.y wy r.y
    && Q.leq
         (Q.abs (Outline.cross p q r))
         (Q.add
            (Q.mul wx (Q.abs (Q.sub q.y p.y)))
            (Q.mul wy (Q.abs (Q.sub q.x p.x))))
    || (upright s && Q.leq (Q.abs (Q.sub r.x p.x)) wx && reach p.y q.y wy r.y)
  in
  let follows ((p, q) as e) =
    List.exists (fun s -> beside s p && beside s q && beside s (middle e)) exact
  in
  List.for_all (fun e -> follows (side e)) edges

let borders_nearly outline =
  let edges = border outline and exact = List.map spot outline in
  let sides = List.map side edges in
  let check what holds = holds || Candor_oracle.Law.fail "%s" what in
  check "edges meet" (well_formed edges)
  && check "an edge bends too far" (bends_little outline edges)
  && check "the area is another"
       (close_to (true_area exact) (enclosed_area sides))
  && check "another winding"
       (List.for_all
          (fun r -> (not (far_from exact r)) || winds_where exact sides r)
          samples)
  && check "an edge parts nothing" (List.for_all (parts exact) sides)

(* Places are corners' own where sides only meet; and one spot has one. *)
let one_place outline =
  let lift i (x, y) =
    Point.v (float_of_int x) (float_of_int y) (float_of_int i)
  in
  let corners = List.mapi lift outline in
  let edges = border_of corners in
  let ends =
    List.concat_map (fun (e : Border.edge) -> [ e.left; e.right ]) edges
  in
  let agree (a : Flat.t) (b : Flat.t) =
    (not (Flat.equal a b)) || Point.equal a.place b.place
  in
  all_pairs agree ends
  && List.for_all
       (fun (a : Flat.t) -> List.exists (Point.equal a.place) corners)
       ends

let no_matter_how outline =
  let shown outline = List.map side (border outline) in
  let same (p, q) (r, s) = equal p r && equal q s in
  let first = shown outline in
  let turned = match outline with [] -> [] | c :: rest -> rest @ [ c ] in
  List.equal same first (shown turned)
  && List.equal same first (shown (List.rev outline))
  && List.equal same first (shown (List.concat_map (fun c -> [ c; c ]) outline))

(* {1 Known ones} *)

let edge (a, b) (c, d) = (spot (a, b), spot (c, d))

let known_borders =
  [
    ("no corner has no border", [], []);
    ("one corner has no border", [ (1, 2) ], []);
    ("there and back has no border", [ (0, 0); (3, 1) ], []);
    ( "a square has its sides",
      square,
      [
        edge (0, 0) (4, 0);
        edge (0, 0) (0, 4);
        edge (0, 4) (4, 4);
        edge (4, 0) (4, 4);
      ] );
    ( "a spike is no border",
      [ (0, 0); (4, 0); (9, 0); (4, 0); (4, 4) ],
      [ edge (0, 0) (4, 0); edge (0, 0) (4, 4); edge (4, 0) (4, 4) ] );
    ( "a bow-tie is two triangles that meet in the crossing",
      bow_tie,
      [
        edge (0, 0) (2, 2);
        edge (0, 0) (0, 4);
        edge (0, 4) (2, 2);
        edge (2, 2) (4, 0);
        edge (2, 2) (4, 4);
        edge (4, 0) (4, 4);
      ] );
    ( "sides that are run along twice the same way part once",
      square @ square,
      [
        edge (0, 0) (4, 0);
        edge (0, 0) (0, 4);
        edge (0, 4) (4, 4);
        edge (4, 0) (4, 4);
      ] );
    ("what is unwound again has no border", square @ List.rev square, []);
    ( "a square within a square wound alike is no border",
      [ (0, 0); (9, 0); (9, 9); (0, 9); (0, 0) ]
      @ [ (3, 3); (6, 3); (6, 6); (3, 6); (3, 3) ],
      [
        edge (0, 0) (9, 0);
        edge (0, 0) (0, 9);
        edge (0, 9) (9, 9);
        edge (9, 0) (9, 9);
      ] );
  ]

let show_sides sides =
  let one (p, q) =
    Printf.sprintf "(%s %s)-(%s %s)" (Q.to_string p.x) (Q.to_string p.y)
      (Q.to_string q.x) (Q.to_string q.y)
  in
  String.concat "\n" (List.map one sides)

let test_known_border (name, outline, expected) =
  case name @@ fun () ->
  Alcotest.(check string)
    "edges" (show_sides expected)
    (show_sides (List.map side (border outline)))

let test_keyhole () =
  let edges = border keyhole in
  Alcotest.(check int) "without the slit" 8 (List.length edges);
  Alcotest.(check bool) "exact" true (borders_exactly keyhole edges)

let strand_corners outline =
  let corner (t, noise) =
    let t = float_of_int t in
    Point.v ((t /. 7.) +. (0x1p-52 *. float_of_int noise)) (t /. 3.) 0.
  in
  List.map corner outline

let strands_part outline = well_formed (border_of (strand_corners outline))

let suite =
  ( "border",
    List.map test_known_border known_borders
    @ [
        case "the slit of a keyhole is no border" test_keyhole;
        law "where no sides cross the border is exact" star_shaped
          (fun outline -> borders_exactly outline (border outline));
        law ~count:200
          "in a tangle edges meet at ends, follow its sides and part what it \
           winds around"
          tangle borders_nearly;
        law ~count:100 "so they do in a tangle of long sides" wild (fun o ->
            let edges = border o in
            well_formed edges && bends_little o edges);
        law ~count:300 "edges too close to tell apart meet at ends" strand
          strands_part;
        law "corners in one spot become one" star_shaped (fun outline ->
            one_place (outline @ outline));
        law "the first corner, the way round and needless ones do not matter"
          star_shaped no_matter_how;
      ] )
