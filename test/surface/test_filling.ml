open Candor_surface
open Outline
open Test_polygon
open Test_border

(* All on what is seen: there everything is exact, whatever was rounded. *)
let seen (a : Flat.t) = { x = Q.of_float a.u; y = Q.of_float a.v }
let seen_side (e : Border.edge) = (seen e.left, seen e.right)
let seen_triangle (a, b, c) = (seen a, seen b, seen c)

let ends_of edges =
  List.concat_map (fun (e : Border.edge) -> [ e.left; e.right ]) edges

(* No two sides run the same way between the same ends: none overlap. *)
let sides_differ triangles =
  let order (p, q) (r, s) =
    let by get a b = Q.compare (get a) (get b) in
    let x p = p.x and y p = p.y in
    List.find_opt (( <> ) 0) [ by x p r; by y p r; by x q s; by y q s ]
    |> Option.value ~default:0
  in
  let sides = triangle_sides triangles in
  List.length sides = List.length (List.sort_uniq order sides)

let centre (a, b, c) =
  let third f = Q.div (sum [ f a; f b; f c ]) (Q.of_int 3) in
  { x = third (fun p -> p.x); y = third (fun p -> p.y) }

let check what holds = holds || Candor_oracle.Law.fail "%s" what

let fills_border edges =
  let found = Filling.triangles edges in
  let triangles = List.map seen_triangle found in
  let sides = List.map seen_side edges and ends = ends_of edges in
  let corner p = List.exists (Flat.equal p) ends in
  let covered_once t =
    let r = centre t in
    encloses sides r
    && List.length (List.filter (fun other -> holds other r) triangles) = 1
  in
  check "a corner is no end of an edge"
    (List.for_all (fun (a, b, c) -> corner a && corner b && corner c) found)
  && check "a triangle is not counter-clockwise"
       (List.for_all (fun t -> Q.sign (double_area t) > 0) triangles)
  && check "the areas differ" (Q.equal (area triangles) (enclosed_area sides))
  && check "a corner is on a side" (sealed triangles)
  && check "two have a side in common on the same hand" (sides_differ triangles)
  && check "one is outside, or under another"
       (List.for_all covered_once triangles)

(* A simple outline of n corners takes n - 2; and every end is a corner. *)
let fills_simply outline =
  let edges = border outline in
  let found = Filling.triangles edges in
  let exact = List.map spot outline in
  let of_place (a, b, c) = (at a, at b, at c) in
  let triangles = List.map of_place found in
  List.length found = List.length outline - 2
  && Q.equal (area triangles) (true_area exact)
  && covers_all exact triangles (grid 9)
  && fills_border edges

let test_none () =
  Alcotest.(check int) "triangles" 0 (List.length (Filling.triangles []))

let test_one () =
  match Filling.triangles (border [ (0, 0); (0, 4); (4, 0) ]) with
  | [ (a, b, c) ] ->
      let t = (at a, at b, at c) in
      check_q "area" (Q.of_int 8) (area [ t ]);
      Alcotest.(check int) "counter-clockwise" 1 (Q.sign (double_area t))
  | found -> Alcotest.failf "%d triangles" (List.length found)

let test_filled (name, outline, area', count) =
  case (name ^ " is filled within its border") @@ fun () ->
  let edges = border outline in
  let found = Filling.triangles edges in
  Alcotest.(check int) "triangles" count (List.length found);
  let of_place (a, b, c) = (at a, at b, at c) in
  check_q "area" area' (area (List.map of_place found));
  Alcotest.(check bool) "filled" true (fills_border edges)

let suite =
  ( "filling",
    [
      case "no border encloses nothing" test_none;
      case "a triangle is filled by itself" test_one;
    ]
    @ List.map test_filled known
    @ [
        law ~count:60
          "an outline seen whole from a point takes two fewer than corners"
          star_shaped fills_simply;
        law ~count:100 "a tangle's border is filled exactly" tangle (fun o ->
            fills_border (border o));
        law ~count:40 "so is that of a tangle of long sides" wild (fun o ->
            fills_border (border o));
        law ~count:60 "so is one of edges too close to tell apart" strand
          (fun o -> fills_border (border_of (strand_corners o)));
      ] )
