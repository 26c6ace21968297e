open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families
open QCheck2
open Moved

(* {1 Agreement} *)

let show_hit = function
  | None -> "nothing"
  | Some (h : _ Hit.t) ->
      Printf.sprintf "part %d %s at t = %h, %s, normal %s, off by %h" h.part
        (Side.show h.side) h.t (Draw.show_point h.point)
        (Draw.show_vec (h.normal :> Vec.t))
        h.offset

(* A group turns normals by its matrix and makes them unit again, motion leaves
   them. *)
let near_normals a b =
  Vec.largest (Vec.sub (a : Dir.t :> Vec.t) (b : Dir.t :> Vec.t)) <= 0x1p-51

(* Up to what going through a group that moves by nothing adds to the error. *)
let near_offsets (h : _ Hit.t) offset =
  let size (p : Point.t) = Vec.norm1 (Point.sub p Point.origin) in
  Float.abs (h.offset -. offset)
  <= (0x1p-50 *. h.offset) +. (0x1p-94 *. (size h.point +. size h.local.point))

let agree what expected found =
  (match (expected, found) with
    | None, None -> true
    | Some (a : _ Hit.t), Some (b : _ Hit.t) ->
        Float.equal a.t b.t
        && Point.equal a.point b.point
        && near_normals a.normal b.normal
        && near_normals a.shading_normal b.shading_normal
        && near_offsets a b.offset && a.side = b.side && a.part = b.part
        && a.material = b.material
    | None, Some _ | Some _, None -> false)
  || Law.fail "%s: expected %s, found %s" what (show_hit expected)
       (show_hit found)

let lifted ({ case = { shape; ray }; time; _ } as m) =
  let s = Shapes.surface 0 shape in
  agree "moved"
    (Surface.nearest (translated m s) ray)
    (Surface.nearest (moving m s) ~time ray)

(* A surface in [transforms], innermost first, each level moving as [m] says. *)
let levels around m transforms s =
  List.fold_left
    (fun s transform ->
      around m (Surface.seen_through ~transform (Surface.group [| s |])))
    (around m s) transforms

let nested (({ case = { shape; ray }; time; _ } as m), steps) =
  let transforms = List.map transform steps in
  let s = Shapes.surface 0 shape in
  let out =
    List.fold_left
      (fun p t ->
        Point.add
          (Affine.point (Transform.forward t).high p)
          (Vec.scale m.time m.velocity))
      ray.origin transforms
  and along =
    List.fold_left
      (fun d t -> Affine.vector (Transform.forward t).high d)
      ray.direction transforms
  in
  let ray = Ray.v out along in
  agree "nested"
    (Surface.nearest (levels translated m transforms s) ray)
    (Surface.nearest (levels moving m transforms s) ~time ray)

(* A definition that is used twice moves as its uses do. *)
let shared ({ case = { shape; ray }; time; _ } as m) =
  let definition around =
    Surface.group [| Shapes.surface 0 shape; around (Shapes.surface 1 shape) |]
  in
  let scene around =
    let one = definition around in
    Surface.group [| around one; one |]
  in
  agree "shared"
    (Surface.nearest (scene (translated m)) ray)
    (Surface.nearest (scene (moving m)) ~time ray)

(* {1 Many} *)

type crowd = {
  members : (Shapes.t * Vec.t) array;
  shutter : float * float;
  times : float list;
  ray : Ray.t;
}

let crowd =
  let open Gen in
  let* { Shapes.shapes; ray } = Shapes.scene and* shutter = shutter in
  let* velocities = array_size (return (Array.length shapes)) velocity in
  let* times = list_size (return 4) (within shutter) in
  return { members = Array.combine shapes velocities; shutter; times; ray }

let show_crowd { members; shutter; times; ray } =
  let member (s, v) = Shapes.show s ^ " by " ^ Draw.show_vec v in
  Printf.sprintf "%s\nin [%h;%h] at %s\n%s"
    (String.concat "\n" (List.map member (Array.to_list members)))
    (fst shutter) (snd shutter)
    (String.concat ", " (List.map (Printf.sprintf "%h") times))
    (Draw.show_ray ray)

let member { shutter; _ } i (s, velocity) =
  Surface.moving ~velocity ~shutter (Shapes.surface i s)

let everyone c = Surface.group (Array.mapi (member c) c.members)

(* The least by (t, place), each asked alone. *)
let alone c ~time =
  Array.mapi (fun i m -> Surface.nearest (member c i m) ~time c.ray) c.members
  |> Array.to_seq |> Seq.filter_map Fun.id
  |> Seq.fold_left
       (fun best (h : _ Hit.t) ->
         match best with
         | Some (b : _ Hit.t) when b.t <= h.t -> best
         | Some _ | None -> Some h)
       None

let scanned c =
  let group = everyone c in
  List.for_all
    (fun time ->
      let expected = alone c ~time
      and found = Surface.nearest group ~time c.ray in
      agree "in a crowd" expected found
      && match found with None -> true | Some h -> h.path = [ h.material ])
    c.times

let blocked c =
  let group = everyone c in
  let agrees time limit =
    Surface.blocked group ~time ~limit c.ray
    = Option.is_some (Surface.nearest group ~limit ~time c.ray)
  in
  List.for_all
    (fun time ->
      let limits =
        match Surface.nearest group ~time c.ray with
        | None -> [ infinity ]
        | Some h -> [ infinity; h.t; Float.pred h.t; h.t /. 2. ]
      in
      List.for_all (agrees time) limits)
    c.times

(* {1 Standing still} *)

let same_bits (a : _ Hit.t option) (b : _ Hit.t option) =
  let frozen (h : _ Hit.t) = { h.local with uv = Lazy.from_val None } in
  match (a, b) with
  | None, None -> true
  | Some a, Some b ->
      List.for_all2 Float.equal [ a.t; a.offset ] [ b.t; b.offset ]
      && Point.equal a.point b.point
      && Dir.equal a.normal b.normal
      && Dir.equal a.shading_normal b.shading_normal
      && a.side = b.side && a.part = b.part && a.path = b.path
      && frozen a = frozen b
  | None, Some _ | Some _, None -> false

let bits what a b =
  same_bits a b
  || Law.fail "%s: expected %s, found %s" what (show_hit a) (show_hit b)

let still ({ case = { shape; ray }; shutter; time; _ } as m) =
  let s = Shapes.surface 0 shape in
  let pair one = Surface.group [| one s; Surface.group [| one s |] |] in
  let expected = Surface.nearest (pair Fun.id) ray in
  let zero = Vec.v 0. (-0.) 0. in
  bits "by nothing" expected
    (Surface.nearest (pair (moving { m with velocity = zero })) ~time ray)
  && bits "at time 0" expected
       (Surface.nearest
          (pair (moving { m with shutter = (0., snd shutter) }))
          ~time:0. ray)
  && bits "at no time given" expected
       (Surface.nearest (pair (moving { m with shutter = (0., 0.) })) ray)

let timeless ({ case = { shape; ray }; time; _ } : Moved.t) =
  let s = Shapes.surface 0 shape in
  bits "what does not move" (Surface.nearest s ray)
    (Surface.nearest s ~time ray)

(* {1 Leaving} *)

let convex : Shapes.t -> bool = function
  | Sphere _ | Box _ | Triangle _ -> true
  | Quadric _ -> false

let directions = Gen.oneof [ Draw.unit; Draw.axial ]

let leaves s ~time (h : _ Hit.t) toward =
  let out = (h.local.normal :> Vec.t) in
  let d = if Vec.dot out toward > 0. then toward else Vec.neg toward in
  let d = if h.side = Outside then d else Vec.neg d in
  let h' = Surface.nearest s ~time (Hit.spawn h d) in
  match h.side with
  | Outside -> h' = None || Law.fail "it meets %s again" (show_hit h')
  | Inside -> (
      match h' with
      | None -> true
      | Some h' -> h'.side = Inside || Law.fail "it enters what it is in")

let departs (({ case = { shape; ray }; time; _ } as m), toward) =
  let s = moving m (Shapes.surface 0 shape) in
  (not (convex shape))
  ||
  match Surface.nearest s ~time ray with
  | None -> true
  | Some h -> h.path = [ 0 ] && leaves s ~time h toward

let departs_in_groups (({ case = { shape; ray }; time; _ } as m), toward) =
  let one = moving m (Shapes.surface 0 shape) in
  let group = Surface.group [| one |] in
  let s = Surface.group [| Surface.group [||]; moving m group |] in
  let ray =
    Ray.v (Point.add ray.origin (Vec.scale time m.velocity)) ray.direction
  in
  (not (convex shape))
  ||
  match Surface.nearest s ~time ray with
  | None -> true
  | Some h -> h.path = [ 1; 0 ] && leaves s ~time h toward

(* {1 Scale} *)

let scaled (({ case = { shape; ray }; velocity; time; _ } as m), k) =
  let c = Shapes.scaling k in
  match Shapes.change c shape with
  | None -> true
  | Some shape' -> (
      let longer = { m with velocity = Vec.scale c.length velocity } in
      let ask m shape ray =
        Surface.nearest (moving m (Shapes.surface 0 shape)) ~time ray
      in
      match (ask m shape ray, ask longer shape' (Shapes.change_ray c ray)) with
      | None, None -> true
      | Some a, Some b ->
          Float.equal (a.t *. c.length) b.t
          && Point.equal (c.point a.point) b.point
          && Dir.equal a.normal b.normal
          && Float.equal (a.offset *. c.length) b.offset
          && a.side = b.side && a.part = b.part
          || Law.fail "%s became %s" (show_hit (Some a)) (show_hit (Some b))
      | a, b -> Law.fail "%s became %s" (show_hit a) (show_hit b))

(* Velocities whose displacements stay in range when scaled. *)
let ordinary =
  Gen.map
    (fun ({ velocity; _ } as m) ->
      let few x = if Float.abs x < 0x1p-60 then 0. else x in
      {
        m with
        velocity = Vec.v (few velocity.x) (few velocity.y) (few velocity.z);
      })
    moved

(* {1 Examples} *)

let unit_at x = Surface.sphere (Made.sphere (Point.v x 0. 0.) 1.) ()
let down x = Ray.v (Point.v x 0. 10.) (Vec.v 0. 0. (-1.))

let path_at s ~time x =
  Option.map (fun (h : _ Hit.t) -> h.path) (Surface.nearest s ~time (down x))

let places () =
  let moving = Surface.moving ~velocity:(Vec.v 10. 0. 0.) ~shutter:(0., 1.) in
  let scene =
    Surface.group
      [|
        unit_at 0.;
        moving (Surface.group [| unit_at 5. |]);
        moving (unit_at 20.);
      |]
  in
  let check what time x expected =
    Alcotest.(check (option (list int))) what expected (path_at scene ~time x)
  in
  check "still, at 0" 0. 0. (Some [ 0 ]);
  check "still, at 1" 1. 0. (Some [ 0 ]);
  check "a member of a moving group" 0. 5. (Some [ 1; 0 ]);
  check "the same, half-way" 0.5 10. (Some [ 1; 0 ]);
  check "it has left" 0.5 5. None;
  check "a moving sphere" 1. 30. (Some [ 2 ]);
  check "it has left too" 1. 20. None

(* Motion is in the axes outside of the surface's own transform. *)
let axes () =
  let turn = transform [ Rotate { axis = Vec.v 0. 0. 1.; degrees = 90. } ] in
  let moving = Surface.moving ~velocity:(Vec.v 4. 0. 0.) ~shutter:(0., 1.) in
  let outside =
    moving
      (Surface.seen_through ~transform:turn (Surface.group [| unit_at 0. |]))
  and inside = Surface.seen_through ~transform:turn (moving (unit_at 0.)) in
  let at x y = Ray.v (Point.v x y 10.) (Vec.v 0. 0. (-1.)) in
  let meets s ray = Surface.blocked s ~time:1. ~limit:infinity ray in
  Alcotest.(check bool) "along x" true (meets outside (at 4. 0.));
  Alcotest.(check bool) "not along y" false (meets outside (at 0. 4.));
  Alcotest.(check bool) "turned to y" true (meets inside (at 0. 4.));
  Alcotest.(check bool) "from x" false (meets inside (at 4. 0.))

let twice () =
  let moving = Surface.moving ~velocity:(Vec.v 2. 0. 0.) ~shutter:(0., 1.) in
  let s = Surface.group [| moving (moving (unit_at 0.)) |] in
  Alcotest.(check (option (list int)))
    "motions add up" (Some [ 0 ]) (path_at s ~time:1. 4.);
  Alcotest.(check (option (list int)))
    "and leave neither alone" None (path_at s ~time:1. 2.)

let textbook () =
  let moving = Surface.moving ~velocity:(Vec.v 10. 0. 0.) ~shutter:(0., 1.) in
  let s = Surface.group ~math:Textbook [| moving (unit_at 0.) |] in
  match Surface.nearest s ~time:0.5 (down 5.) with
  | None -> Alcotest.fail "not where it has moved"
  | Some h ->
      Alcotest.(check (float 0.)) "t" 9. h.t;
      Alcotest.(check (float 0.)) "x" 5. h.point.x;
      Alcotest.(check (float 0.)) "offset" 0. h.offset

let law ?(count = 2000) name gen holds =
  Law.law ~count ~print:show name gen holds

let beside f = fun (m, _) -> f m

let steps =
  Gen.list_size (Gen.int_range 1 3)
    (Gen.list_size (Gen.return 2) Test_queries.step)

let suite =
  ( "surfaces that move",
    [
      Law.example "what moves keeps its place" places;
      Law.example "motion is in the axes of the parent" axes;
      Law.example "motion within motion adds up" twice;
      Law.example "the textbook moves surfaces as well" textbook;
      law "at time t a surface stands as if moved by t times the velocity" moved
        lifted;
      Law.law ~count:1000 ~print:(beside show)
        "so it does within groups that are turned, scaled and moving"
        (Gen.pair moved steps) nested;
      law ~count:1000 "so it does in shared definitions" moved shared;
      Law.law ~count:1500 ~print:show_crowd
        "a group of moving surfaces is met like a linear scan of them" crowd
        scanned;
      Law.law ~count:1000 ~print:show_crowd
        "moving surfaces are in the way where one of them is hit" crowd blocked;
      law "moved by nothing a surface stands still, bit for bit" moved still;
      law ~count:500 "time is nothing to what does not move" moved timeless;
      Law.law ~print:(beside show)
        "a ray that leaves a moving surface does not meet it at the start"
        (Gen.pair moved directions)
        departs;
      Law.law ~print:(beside show)
        "nor one that leaves a moving member of a moving group"
        (Gen.pair moved directions)
        departs_in_groups;
      Law.law ~count:1000 ~print:(beside show)
        "scaling lengths by 2^k, velocities too, leaves the bits"
        (Gen.pair ordinary (Gen.int_range (-60) 60))
        scaled;
    ] )
