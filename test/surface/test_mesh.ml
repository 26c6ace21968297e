(* Meshes of triangles, which rays must cross consistently. *)

open Candor_space
open Candor_oracle
open Candor_surface_families
open QCheck2

let p = Point.v
let v = Vec.v

(* A grid over two parameters, wrapped round on both or on one with poles. *)
type mesh = { corners : Point.t array; faces : (int * int * int) array }

let show_mesh m =
  String.concat " " (Array.to_list (Array.map Draw.show_point m.corners))

(* A ball of [rings] x [turns] quads with two poles: closed, convex if its
   corners are on an ellipsoid. *)
let ball ~rings ~turns at =
  let corner i j = 2 + (i * turns) + (j mod turns) in
  let north = at 0. 0. and south = at 1. 0. in
  let ring i =
    Array.init turns (fun j ->
        at
          (float_of_int (i + 1) /. float_of_int (rings + 1))
          (float_of_int j /. float_of_int turns))
  in
  let corners = Array.concat ([| north; south |] :: List.init rings ring) in
  let faces = ref [] in
  for j = 0 to turns - 1 do
    faces := (0, corner 0 j, corner 0 (j + 1)) :: !faces;
    faces := (1, corner (rings - 1) (j + 1), corner (rings - 1) j) :: !faces;
    for i = 0 to rings - 2 do
      let a = corner i j and b = corner i (j + 1) in
      let c = corner (i + 1) j and d = corner (i + 1) (j + 1) in
      faces := (a, c, d) :: (a, d, b) :: !faces
    done
  done;
  { corners; faces = Array.of_list !faces }

let on_ball theta phi =
  let t = Float.pi *. theta and f = 2. *. Float.pi *. phi in
  v (sin t *. cos f) (sin t *. sin f) (cos t)

let mesh_of { corners; faces } =
  Array.map
    (fun (i, j, k) -> Made.triangle corners.(i) corners.(j) corners.(k))
    faces

(* How often the ray crosses the mesh, by the side it comes from. *)
let crossings triangles ray =
  Array.fold_left
    (fun (entered, left) s ->
      match Triangles.kind.answer s ray with
      | Some { side = Outside; _ } -> (entered + 1, left)
      | Some { side = Inside; _ } -> (entered, left + 1)
      | None -> (entered, left))
    (0, 0) triangles

type aimed = { mesh : mesh; ray : Ray.t }

let show { mesh; ray } = show_mesh mesh ^ "\n" ^ Draw.show_ray ray

let face { corners; faces } =
  Gen.map
    (fun f ->
      let i, j, k = faces.(f) in
      (corners.(i), corners.(j), corners.(k)))
    (Gen.int_bound (Array.length faces - 1))

(* A corner, a point of an edge or of a face of the mesh. *)
let aim mesh =
  Gen.(
    let* a, b, c = face mesh in
    Triangles.point_of (Triangles.between a b c))

let aim_at_corner mesh = Gen.map (fun (a, _, _) -> a) (face mesh)

let aim_at_edge mesh =
  Gen.map2
    (fun (a, b, _) k -> Triangles.middle a b k)
    (face mesh) (Draw.uniform 0. 1.)

let frame =
  let open Gen in
  let* size = Draw.wide (-3.) 3.
  and* far = Draw.either 50 (return 0.) (Draw.wide 0. 6.) in
  let* d = Draw.unit in
  return (Draw.move Point.origin d far, size)

(* Rounding the corners of a ball at 1e6 leaves it closed, but not convex. *)
let convex aim =
  let open Gen in
  let* c, size = frame in
  let at theta phi = Draw.move c (on_ball theta phi) size in
  let mesh = ball ~rings:3 ~turns:5 at in
  let* target = aim mesh and* from = Draw.vec (Draw.uniform (-0.2) 0.2) in
  let o = Draw.move c from size in
  return { mesh; ray = Ray.v o (Draw.toward o target) }

let leaves_once { mesh; ray } =
  let entered, left = crossings (mesh_of mesh) ray in
  (entered = 0 && left = 1)
  || Law.fail "entered %d times, left %d times" entered left

let dented =
  let open Gen in
  let* c, size = frame in
  let* dents = array_size (return 17) (Draw.uniform 0.2 3.) in
  let next = ref 0 in
  let at theta phi =
    let k = dents.(!next mod 17) in
    incr next;
    Draw.move c (on_ball theta phi) (size *. k)
  in
  let mesh = ball ~rings:3 ~turns:5 at in
  let* target = aim mesh and* inside = bool in
  let* n = Draw.unit in
  let o =
    if inside then Draw.move c n (0.01 *. size) else Draw.move c n (10. *. size)
  in
  return ({ mesh; ray = Ray.v o (Draw.toward o target) }, inside)

let parity ({ mesh; ray }, inside) =
  let entered, left = crossings (mesh_of mesh) ray in
  (left - entered = if inside then 1 else 0)
  || Law.fail "entered %d times, left %d times" entered left

(* Whole corners: rays through them meet exact ties everywhere. *)
let height_field =
  let open Gen in
  let n = 6 in
  let* heights = array_size (return ((n + 1) * (n + 1))) (Draw.small 2) in
  let corners =
    Array.init
      ((n + 1) * (n + 1))
      (fun i ->
        p
          (float_of_int (i mod (n + 1)))
          (float_of_int (i / (n + 1)))
          heights.(i))
  in
  let faces =
    Array.init
      (2 * n * n)
      (fun f ->
        let cell = f / 2 in
        let a = (cell / n * (n + 1)) + (cell mod n) in
        let b = a + 1 and c = a + n + 1 in
        if f land 1 = 0 then (a, b, c + 1) else (a, c + 1, c))
  in
  let inside =
    map (fun k -> 1. +. (float_of_int k /. 2.)) (int_bound ((2 * n) - 4))
  in
  let* x = inside and* y = inside and* k = int_range (-20) 20 in
  let* down = Draw.sign in
  let by = Float.ldexp 1. k in
  let scale (q : Point.t) = p (by *. q.x) (by *. q.y) (by *. q.z) in
  return
    {
      mesh = { corners = Array.map scale corners; faces };
      ray = Ray.v (scale (p x y (-9. *. down))) (v 0. 0. down);
    }

let once { mesh; ray } =
  let entered, left = crossings (mesh_of mesh) ray in
  entered + left = 1 || Law.fail "met %d times" (entered + left)

let seam () =
  (* T8: a quad divided on y = x, and a ray in the dividing plane. *)
  let a = p (-5.) (-5.) 0. and b = p 5. (-5.) 0. and c = p 5. 5. 0. in
  let e = p (-5.) 5. 0. in
  let ray = Ray.v (p 0. 0. 10.) (v 0.30458447 0.30458447 (-0.9024725)) in
  let quad = [| Made.triangle a b c; Made.triangle a c e |] in
  Alcotest.(check (pair int int)) "met once" (1, 0) (crossings quad ray)

let suite =
  ( "meshes",
    [
      Law.example "T8: a quad is met once on its diagonal" seam;
      Law.law ~count:1000 ~print:show
        "T1: a closed convex mesh is left once, through a corner too"
        (convex aim_at_corner) leaves_once;
      Law.law ~count:1000 ~print:show
        "T2: a closed convex mesh is left once, through an edge too"
        (convex aim_at_edge) leaves_once;
      Law.law ~count:2000
        ~print:(fun (a, _) -> show a)
        "a closed mesh is left once more than entered from inside, as often \
         from outside"
        dented parity;
      Law.law ~count:2000 ~print:show
        "T3: a height field of whole corners is met exactly once" height_field
        once;
    ] )
