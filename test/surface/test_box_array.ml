open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2

let box_of number =
  let open Gen in
  let* a = Draw.point number and* b = Draw.point number in
  return (Bounds.of_points [ a; b ])

let huge = Draw.signed (Draw.wide 290. 308.2)

let full =
  Gen.oneof
    [
      box_of (Draw.small 3);
      box_of Draw.any_coordinate;
      box_of (Gen.oneof [ Draw.small 1; huge ]);
    ]

let box = Draw.either 15 (Gen.return Bounds.empty) full

let alone b =
  let a = Box_array.create 1 in
  Box_array.set a 0 b;
  a

let ends (b : Bounds.t) = function
  | 0 -> (b.x0, b.x1)
  | 1 -> (b.y0, b.y1)
  | _ -> (b.z0, b.z1)

(* {1 Against Bounds} *)

type step =
  | Set of int * Bounds.t
  | Clear of int
  | Grow of int * int
  | Copy of int * int

let size = 5

let step =
  let open Gen in
  let place = int_bound (size - 1) in
  oneof
    [
      map2 (fun i b -> Set (i, b)) place box;
      map (fun i -> Clear i) place;
      map2 (fun i j -> Grow (i, j)) place place;
      map2 (fun i j -> Grow (i, j)) place place;
      map2 (fun i j -> Copy (i, j)) place place;
    ]

let show_step = function
  | Set (i, b) -> Printf.sprintf "%d := %s" i (Bounds.show b)
  | Clear i -> Printf.sprintf "clear %d" i
  | Grow (i, j) -> Printf.sprintf "grow %d by %d" i j
  | Copy (i, j) -> Printf.sprintf "%d := box %d" i j

let show_steps steps = String.concat "\n" (List.map show_step steps)

(* [flat.(other)] is where grow and copy read from. *)
let apply flat other = function
  | Set (i, b) -> Box_array.set flat i b
  | Clear i -> Box_array.clear flat i
  | Grow (i, j) -> Box_array.grow flat i other j
  | Copy (i, j) -> Box_array.copy flat i other j

let model boxes others = function
  | Set (i, b) -> boxes.(i) <- b
  | Clear i -> boxes.(i) <- Bounds.empty
  | Grow (i, j) -> boxes.(i) <- Bounds.join boxes.(i) others.(j)
  | Copy (i, j) -> boxes.(i) <- others.(j)

let cleared () =
  let flat = Box_array.create size in
  for i = 0 to size - 1 do
    Box_array.clear flat i
  done;
  flat

let agrees flat boxes =
  List.for_all
    (fun i -> Bounds.equal (Box_array.get flat i) boxes.(i))
    (List.init size Fun.id)

let as_bounds (steps, more) =
  let flat = cleared () and boxes = Array.make size Bounds.empty in
  let flat' = cleared () and boxes' = Array.make size Bounds.empty in
  List.iter (apply flat flat) steps;
  List.iter (model boxes boxes) steps;
  (* From one array to another. *)
  List.iter (apply flat' flat) more;
  List.iter (model boxes' boxes) more;
  agrees flat boxes && agrees flat' boxes'

let layout () =
  let b = Bounds.v (Point.v 0. 2. 4.) (Point.v 1. 3. 5.) in
  let flat = Box_array.create 2 in
  Box_array.clear flat 0;
  Box_array.set flat 1 b;
  Alcotest.(check int) "room" 12 (Float.Array.length flat);
  Alcotest.(check (list (float 0.)))
    "x0 x1 y0 y1 z0 z1" [ 0.; 1.; 2.; 3.; 4.; 5. ]
    (List.init 6 (fun k -> Float.Array.get flat (6 + k)))

(* {1 Measures} *)

let half = Q.of_ints 1 2

let middles b =
  let flat = alone b in
  List.for_all
    (fun axis ->
      let lo, hi = ends b axis in
      let x = Box_array.center flat 0 axis in
      let middle = Exact.(half * (q lo + q hi)) in
      let normal x = x = 0. || Float.abs x > 0x1p-1000 in
      Exact.within 1. x middle
      && ((not (normal lo && normal hi)) || (lo <= x && x <= hi)))
    [ 0; 1; 2 ]

let lengths b =
  let flat = alone b in
  List.for_all
    (fun axis ->
      let lo, hi = ends b axis in
      Box_array.low flat 0 axis = lo && Box_array.extent flat 0 axis = hi -. lo)
    [ 0; 1; 2 ]

let widest b =
  let length axis =
    let lo, hi = ends b axis in
    hi -. lo
  in
  let found = Box_array.widest (alone b) 0 in
  List.for_all
    (fun axis ->
      let order = Float.compare (length found) (length axis) in
      if axis < found then order > 0 else order >= 0)
    [ 0; 1; 2 ]

let holds_centers (into, from) =
  let flat = alone into and other = alone from in
  Box_array.grow_by_center flat 0 other 0;
  let at = Box_array.center other 0 in
  let center = Point.v (at 0) (at 1) (at 2) in
  Bounds.equal (Box_array.get flat 0)
    (Bounds.join into (Bounds.v center center))

(* By the side that is longest: then a box of any size has an area. *)
let areas b =
  let flat = alone b in
  let unit = Box_array.(extent flat 0 (widest flat 0)) in
  let area = Box_array.half_area flat 0 ~unit in
  let exact =
    let open Exact in
    let side axis =
      let lo, hi = ends b axis in
      (q hi - q lo) / q unit
    in
    let x = side 0 and y = side 1 and z = side 2 in
    (x * y) + (y * z) + (z * x)
  in
  unit = 0. || unit = infinity
  || Q.leq
       (Q.abs Exact.(q area - exact))
       Exact.((power (-48) * exact) + power (-1070))

let known_areas () =
  let area ?(unit = 1.) a b =
    Box_array.half_area (alone (Bounds.v a b)) 0 ~unit
  in
  let check = Alcotest.(check (float 0.)) in
  let o = Point.origin in
  check "a cube" 3. (area o (Point.v 1. 1. 1.));
  check "2 by 3 by 4" 26. (area o (Point.v 2. 3. 4.));
  check "the same in units of 2" 6.5 (area ~unit:2. o (Point.v 2. 3. 4.));
  check "flat" 6. (area o (Point.v 2. 3. 0.));
  check "a line" 0. (area o (Point.v 2. 0. 0.));
  check "empty" 0. (Box_array.half_area (alone Bounds.empty) 0 ~unit:1.)

let law name gen holds = Law.law ~print:Bounds.show name gen holds

let suite =
  ( "box array",
    [
      Law.law
        ~print:(fun (a, b) -> show_steps a ^ "\nand then\n" ^ show_steps b)
        "boxes are set, cleared, copied and joined as Bounds are"
        Gen.(
          pair (list_size (int_bound 15) step) (list_size (int_bound 15) step))
        as_bounds;
      Law.example "a box is x0 x1 y0 y1 z0 z1" layout;
      law "the centre is the middle within an ulp, and in the box" full middles;
      law "low end and length are those of the box" box lengths;
      law "the widest axis is the first of the longest" box widest;
      Law.law
        ~print:(fun (a, b) -> Bounds.show a ^ "\n" ^ Bounds.show b)
        "growing by a centre holds that and no more" (Gen.pair box full)
        holds_centers;
      law "half the area is right, whatever the size" full areas;
      Law.example "areas of known boxes" known_areas;
    ] )
