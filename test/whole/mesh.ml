(** Closed meshes of triangles, faces counter-clockwise seen from outside. *)

open Candor_space
open Candor_oracle
open Candor_surface_families

type t = {
  name : string;
  corners : Point.t array;
  faces : (int * int * int) array;
  inside : Point.t array;  (** points well inside *)
}

let p = Point.v
let triangle { corners = c; _ } (i, j, k) = Made.triangle c.(i) c.(j) c.(k)
let triangles m = Array.map (triangle m) m.faces

(** [moved f m] is [m] with every point moved by [f]. *)
let moved f m =
  { m with corners = Array.map f m.corners; inside = Array.map f m.inside }

(** [is_closed m] is whether every edge is in one face each way round. *)
let is_closed m =
  let edges = Hashtbl.create 64 in
  let once = ref true in
  let add e =
    if Hashtbl.mem edges e then once := false;
    Hashtbl.replace edges e ()
  in
  Array.iter (fun (i, j, k) -> List.iter add [ (i, j); (j, k); (k, i) ]) m.faces;
  !once
  && Hashtbl.fold
       (fun (i, j) () ok -> ok && Hashtbl.mem edges (j, i))
       edges true

(** [is_convex m] is whether no corner is outside of any face, exactly. *)
let is_convex m =
  Array.for_all
    (fun s ->
      Array.for_all
        (fun q -> Q.sign (Exact_triangle.value s (Exact.point q)) <= 0)
        m.corners)
    (triangles m)

let origin = [| Point.origin |]

(* {1 Convex} *)

let cube =
  let at bit i = if i land bit = 0 then -1. else 1. in
  let quads =
    [
      (0, 4, 6, 2);
      (1, 3, 7, 5);
      (0, 1, 5, 4);
      (2, 6, 7, 3);
      (0, 2, 3, 1);
      (4, 5, 7, 6);
    ]
  in
  {
    name = "cube";
    corners = Array.init 8 (fun i -> p (at 1 i) (at 2 i) (at 4 i));
    faces =
      Array.of_list
        (List.concat_map (fun (a, b, c, d) -> [ (a, b, c); (a, c, d) ]) quads);
    inside = origin;
  }

(* The faces of the hull of [corners], by trying every triple. *)
let hull name corners =
  let n = Array.length corners in
  let exact = Array.map Exact.point corners in
  let outer i j k =
    let open Exact in
    let a = exact.(i) in
    let normal = cross (sub exact.(j) a) (sub exact.(k) a) in
    Array.for_all (fun x -> Q.sign (dot normal (sub x a)) <= 0) exact
  in
  let faces = ref [] in
  for i = 0 to n - 1 do
    for j = i + 1 to n - 1 do
      for k = i + 1 to n - 1 do
        if k <> j && outer i j k then faces := (i, j, k) :: !faces
      done
    done
  done;
  { name; corners; faces = Array.of_list !faces; inside = origin }

let unit (q : Point.t) =
  let v = Draw.normalised (Point.sub q Point.origin) in
  p v.x v.y v.z

let random_hull seed n =
  let rand = Random.State.make [| seed |] in
  let x () = Random.State.float rand 2. -. 1. in
  let corner _ =
    let a = x () in
    let b = x () in
    unit (p a b (x ()))
  in
  hull (Printf.sprintf "hull of %d points" n) (Array.init n corner)

let icosahedron =
  let g = (1. +. sqrt 5.) /. 2. in
  let signs = [ (1., 1.); (1., -1.); (-1., 1.); (-1., -1.) ] in
  let about (s, t) = [ p 0. s (t *. g); p s (t *. g) 0.; p (t *. g) 0. s ] in
  hull "icosahedron" (Array.of_list (List.concat_map about signs))

let middle (a : Point.t) (b : Point.t) =
  p ((a.x +. b.x) /. 2.) ((a.y +. b.y) /. 2.) ((a.z +. b.z) /. 2.)

(* Every face in four, the new corners moved by [f]. *)
let divided f m =
  let found = Hashtbl.create 64 and corners = ref [] in
  let next = ref (Array.length m.corners) in
  let half i j =
    let key = (Int.min i j, Int.max i j) in
    match Hashtbl.find_opt found key with
    | Some k -> k
    | None ->
        let k = !next in
        incr next;
        Hashtbl.add found key k;
        corners := f (middle m.corners.(i) m.corners.(j)) :: !corners;
        k
  in
  let four (i, j, k) =
    let ij = half i j in
    let jk = half j k in
    let ki = half k i in
    [ (i, ij, ki); (ij, j, jk); (ki, jk, k); (ij, jk, ki) ]
  in
  let faces = List.concat_map four (Array.to_list m.faces) in
  {
    m with
    corners = Array.append m.corners (Array.of_list (List.rev !corners));
    faces = Array.of_list faces;
  }

let ball =
  let even =
    { icosahedron with corners = Array.map unit icosahedron.corners }
  in
  { (divided unit even) with name = "ball of 80 faces" }

(* Coplanar neighbours, corners that are halves: rays in the plane of faces. *)
let tiled_cube = { (divided Fun.id cube) with name = "cube of 48 faces" }
let convex = [ cube; tiled_cube; icosahedron; ball; random_hull 5 24 ]

(* {1 Not convex} *)

(* A pyramid on every face of the icosahedron, every other one inwards. *)
let star =
  let tip n (i, j, k) =
    let c = icosahedron.corners in
    let m (f : Point.t -> float) = (f c.(i) +. f c.(j) +. f c.(k)) /. 3. in
    let by = if n land 1 = 0 then 3. else 0.4 in
    p (by *. m (fun q -> q.x)) (by *. m (fun q -> q.y)) (by *. m (fun q -> q.z))
  in
  let n = Array.length icosahedron.corners in
  let three f (i, j, k) = [ (i, j, n + f); (j, k, n + f); (k, i, n + f) ] in
  {
    name = "star";
    corners =
      Array.append icosahedron.corners (Array.mapi tip icosahedron.faces);
    faces =
      Array.of_list
        (List.concat (List.mapi three (Array.to_list icosahedron.faces)));
    inside = origin;
  }

(* Two quads of a grid that wraps around both ways. *)
let torus =
  let n = 8 and m = 5 in
  let angle i n = 2. *. Float.pi *. float_of_int i /. float_of_int n in
  let at r i j =
    let u = angle i n and v = angle j m in
    let w = 2. +. (r *. cos v) in
    p (w *. cos u) (w *. sin u) (r *. sin v)
  in
  let corner i j = ((i + n) mod n * m) + ((j + m) mod m) in
  let quad q =
    let i = q / m and j = q mod m in
    let a = corner i j and b = corner (i + 1) j in
    let c = corner (i + 1) (j + 1) and d = corner i (j + 1) in
    [ (a, b, c); (a, c, d) ]
  in
  {
    name = "torus";
    corners = Array.init (n * m) (fun c -> at 0.75 (c / m) (c mod m));
    faces = Array.of_list (List.concat_map quad (List.init (n * m) Fun.id));
    inside = Array.init n (fun i -> at 0. i 0);
  }

(* A height field of whole numbers with walls and a floor: spikes, ridges, and
   many corners above each other. *)
let field =
  let n = 3 in
  let side = n + 1 in
  let rand = Random.State.make [| 11 |] in
  let height _ = float_of_int (1 + Random.State.int rand 4) in
  let heights = Array.init (side * side) height in
  let top i j = (j * side) + i in
  let floor i j = (side * side) + top i j in
  let place c = (float_of_int (c mod side), float_of_int (c / side)) in
  let corner c =
    let cell = c mod (side * side) in
    let x, y = place cell in
    p x y (if c < side * side then heights.(cell) else -1.)
  in
  let quad a b c d = [ (a, b, c); (a, c, d) ] in
  let cell q =
    let i = q mod n and j = q / n in
    quad (top i j) (top (i + 1) j) (top (i + 1) (j + 1)) (top i (j + 1))
    @ quad (floor i j)
        (floor i (j + 1))
        (floor (i + 1) (j + 1))
        (floor (i + 1) j)
  in
  let walls i =
    quad (floor i 0) (floor (i + 1) 0) (top (i + 1) 0) (top i 0)
    @ quad (floor (i + 1) n) (floor i n) (top i n) (top (i + 1) n)
    @ quad (floor n i) (floor n (i + 1)) (top n (i + 1)) (top n i)
    @ quad (floor 0 (i + 1)) (floor 0 i) (top 0 i) (top 0 (i + 1))
  in
  {
    name = "closed height field";
    corners = Array.init (2 * side * side) corner;
    faces =
      Array.of_list
        (List.concat_map cell (List.init (n * n) Fun.id)
        @ List.concat_map walls (List.init n Fun.id));
    inside =
      Array.init (n * n) (fun q ->
          p (float_of_int (q mod n) +. 0.5) (float_of_int (q / n) +. 0.5) 0.);
  }

let not_convex = [ star; torus; field ]
