open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families

(* {1 Where meshes stand} *)

type stand = { size : float; at : Point.t }

let stands =
  [
    { size = 1.; at = Point.origin };
    { size = 1.; at = Point.v 3. (-5.) 0.5 };
    { size = 0x1p-20; at = Point.v 1. 2. (-4.) };
    { size = 0x1p30; at = Point.v 0x1p30 0. 0x1p31 };
    { size = 0.0013; at = Point.v 700.1 (-300.2) 55.5 };
    { size = 1234.5; at = Point.v 1e6 1e6 (-1e6) };
  ]

let place { size; at } m =
  Mesh.moved
    (fun q ->
      Point.v
        (at.x +. (size *. q.x))
        (at.y +. (size *. q.y))
        (at.z +. (size *. q.z)))
    m

(* {1 Rays} *)

type kind = Corner | Edge | Face

let kinds = [| Corner; Edge; Face |]

(* A point on the mesh: as it is, halfway or anywhere between corners. *)
let target rand (m : Mesh.t) kind =
  let i, j, k = m.faces.(Random.State.int rand (Array.length m.faces)) in
  let a = m.corners.(i) and b = m.corners.(j) and c = m.corners.(k) in
  let mix u v =
    Point.along (Point.along a (Point.sub b a) u) (Point.sub c a) v
  in
  match kind with
  | Corner -> a
  | Edge when Random.State.bool rand -> Mesh.middle a b
  | Edge -> mix (Random.State.float rand 1.) 0.
  | Face ->
      let u = Random.State.float rand 1. in
      mix u (Random.State.float rand (1. -. u))

let number rand = Random.State.float rand 2. -. 1.

(* Whole numbers beside any, so that rays run along edges and in faces. *)
let direction rand =
  let x () =
    if Random.State.bool rand then float_of_int (Random.State.int rand 5 - 2)
    else number rand
  in
  let a = x () in
  let b = x () in
  let d = Vec.v a b (x ()) in
  if Vec.largest d > 0. then d else Vec.v 0. 0. 1.

type shot = { ray : Ray.t; inside : bool }

(* From well inside towards the target, or from without: every mesh is within 8
   sizes of its stand. *)
let shoot rand stand (m : Mesh.t) =
  let goal = target rand m kinds.(Random.State.int rand 3) in
  if Random.State.bool rand then
    let at = m.inside.(Random.State.int rand (Array.length m.inside)) in
    let jitter =
      if Random.State.bool rand then Vec.zero
      else Vec.scale (0.05 *. stand.size) (direction rand)
    in
    let o = Point.add at jitter in
    { ray = Ray.v o (Point.sub goal o); inside = true }
  else
    let d = direction rand in
    let far = 32. *. stand.size /. Vec.largest d in
    let o = Point.add goal (Vec.scale (-.far) d) in
    let d = if Random.State.bool rand then d else Point.sub goal o in
    { ray = Ray.v o d; inside = false }

(* {1 Truth: every face by itself} *)

type count = { entered : int; left : int; first : float }

let count faces ray =
  let add c face =
    match Surface.nearest face ray with
    | None -> c
    | Some (h : _ Hit.t) -> (
        let first = Float.min c.first h.t in
        match h.side with
        | Outside -> { c with entered = c.entered + 1; first }
        | Inside -> { c with left = c.left + 1; first })
  in
  Array.fold_left add { entered = 0; left = 0; first = infinity } faces

let fail (m : Mesh.t) stand { ray; inside } what =
  Alcotest.failf "%s of size %h at %s, %s, %s: %s" m.name stand.size
    (Draw.show_point stand.at) (Draw.show_ray ray)
    (if inside then "from inside" else "from outside")
    what

(* What every ray must keep to. *)
let crossed ~convex m stand ({ ray; inside } as shot) faces =
  let c = count faces ray in
  let right =
    if convex && inside then c.entered = 0 && c.left = 1
    else if convex then c.entered = c.left && c.entered <= 1
    else c.left - c.entered = if inside then 1 else 0
  in
  if not right then
    fail m stand shot
      (Printf.sprintf "entered %d times, left %d times" c.entered c.left);
  c

(* The whole surface gives the least of these, and a convex one that is left is
   not met again. *)
let met ~convex m stand ({ ray; inside } as shot) whole c =
  match Surface.nearest whole ray with
  | None -> if c.first < infinity then fail m stand shot "nothing found"
  | Some (h : _ Hit.t) ->
      if h.t <> c.first then
        fail m stand shot (Printf.sprintf "t = %h, not %h" h.t c.first);
      if convex && inside then
        Option.iter
          (fun (again : _ Hit.t) ->
            fail m stand shot (Printf.sprintf "met again at %h" again.t))
          (Surface.nearest whole (Hit.spawn h ray.direction))

let faces m = Array.map (fun s -> Surface.triangle s ()) (Mesh.triangles m)

(* {1 Rays in their thousands} *)

let total = 1_000_000 * Law.factor

let sweep meshes rays () =
  let each = rays / (List.length meshes * List.length stands) in
  let stand_mesh m stand =
    let m = place stand m in
    let faces = faces m in
    let whole = Surface.group faces in
    (* Rounding its corners may dent a mesh. *)
    let convex = Mesh.is_convex m in
    let rand = Random.State.make [| Law.seed; Hashtbl.hash m.name |] in
    for i = 1 to each do
      let shot = shoot rand stand m in
      let c = crossed ~convex m stand shot faces in
      if i land 3 = 0 then met ~convex m stand shot whole c
    done
  in
  List.iter (fun m -> List.iter (stand_mesh m) stands) meshes

(* {1 Seen through transforms} *)

(* From inside nothing gets out, and what has got out meets nothing. *)
let through_transforms () =
  let steps : Transform.step list =
    [
      Scale (Vec.v 0x1p-10 0x1p-10 0x1p-10);
      Rotate { axis = Vec.v 1. 2. 3.; degrees = 37. };
      Scale (Vec.v 3. 5. (-7.));
      Translate (Vec.v 0.1 0.2 0.3);
    ]
  in
  let transform = Made.get "transform" (Transform.of_steps steps) in
  let forward q = Affine.point (Transform.forward transform).high q in
  let stand = List.hd stands in
  let leaves (m : Mesh.t) =
    let whole = Surface.seen_through ~transform (Surface.group (faces m)) in
    let rand = Random.State.make [| Law.seed |] in
    for _ = 1 to 10_000 * Law.factor do
      let o = forward m.inside.(0) in
      let goal = forward (target rand m kinds.(Random.State.int rand 3)) in
      let shot = { ray = Ray.v o (Point.sub goal o); inside = true } in
      match Surface.nearest whole shot.ray with
      | None -> fail m stand shot "it leaks"
      | Some h -> (
          if h.side <> Inside then fail m stand shot "met from outside";
          match Surface.nearest whole (Hit.spawn h shot.ray.direction) with
          | None -> ()
          | Some _ -> fail m stand shot "met again")
    done
  in
  List.iter leaves Mesh.convex

let sound () =
  List.iter
    (fun (m : Mesh.t) ->
      Alcotest.(check bool) (m.name ^ " is closed") true (Mesh.is_closed m))
    (Mesh.convex @ Mesh.not_convex);
  List.iter
    (fun (m : Mesh.t) ->
      Alcotest.(check bool) (m.name ^ " is convex") true (Mesh.is_convex m))
    Mesh.convex;
  List.iter
    (fun (m : Mesh.t) ->
      Alcotest.(check bool) (m.name ^ " is not") false (Mesh.is_convex m))
    Mesh.not_convex

let suite =
  ( "closed meshes",
    [
      Law.example "the meshes are closed, convex or not, as they say" sound;
      Law.example
        (Printf.sprintf
           "T1 T2 T8: %d rays at corners, edges and faces leave a convex mesh \
            exactly once from inside, and cross it twice or never from outside"
           (total / 2))
        (sweep Mesh.convex (total / 2));
      Law.example
        (Printf.sprintf
           "T1 T2 T3 T8: %d rays cross a mesh that is not convex an odd number \
            of times from inside, an even one from outside"
           (total / 2))
        (sweep Mesh.not_convex (total / 2));
      Law.example
        "T1 G3: no ray leaks out of a convex mesh under a transform, and none \
         that left it meets it again"
        through_transforms;
    ] )
