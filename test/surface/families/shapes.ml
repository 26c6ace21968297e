(** Surfaces of every kind, as data that can be scaled and mirrored. *)

open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2.Gen
open Draw
open Made

type t =
  | Sphere of Sphere.t
  | Box of Box.t
  | Triangle of Triangle.t
  | Quadric of Quadric.t

let show = function
  | Sphere s -> Spheres.show s
  | Box b -> Boxes.show b
  | Triangle s -> Triangles.show s
  | Quadric q -> Quadrics.show q

let surface m = function
  | Sphere s -> Surface.sphere s m
  | Box b -> Surface.box b m
  | Triangle s -> Surface.triangle s m
  | Quadric q -> Surface.quadric q m

(** [answer s ray] is what the public query says of [s] alone. *)
let answer s = answer (surface () s)

let truth = function
  | Sphere s -> Exact_sphere.truth_along s
  | Box b -> Exact_box.truth_along b
  | Triangle s -> Exact_triangle.truth_along s
  | Quadric q -> Exact_quadric.(truth_along (of_quadric q))

let kind = { Family.show; answer; truth }

(* {1 Transforming} *)

(* What one map does to points, directions and sizes of a shape. *)
type change = {
  point : Point.t -> Point.t;
  normal : Vec.t -> Vec.t;  (** of planes; of length as it was *)
  length : float;
}

let change_box c (b : Bounds.t) =
  let p = c.point (Bounds.low b) and q = c.point (Bounds.high b) in
  Bounds.join (Bounds.v p p) (Bounds.v q q)

let change_matrix c q =
  let at i j = q.((4 * i) + j) in
  let n = c.normal (v 1. 1. 1.) in
  let sign i = if i = 3 then 1. else Vec.get n i in
  let size i = if i = 3 then c.length else 1. in
  Array.init 16 (fun k ->
      let i = k / 4 and j = k mod 4 in
      at i j *. sign i *. sign j *. size i *. size j)

(* [None] where the changed shape cannot be written down. *)
let change_shape c (s : Quadric_shape.t) : Quadric_shape.t option =
  let radii r = Vec.scale c.length r in
  let mirrors_z = Vec.get (c.normal (v 0. 0. 1.)) 2 < 0. in
  match s with
  | Matrix q -> Some (Matrix (change_matrix c q))
  | Form { a; b; c = k } ->
      let n = c.normal (v 1. 1. 1.) in
      let entry i x = x *. Vec.get n (i / 3) *. Vec.get n (i mod 3) in
      Some
        (Form
           {
             a = Array.mapi entry a;
             b = Vec.scale c.length (c.normal b);
             c = k *. c.length *. c.length;
           })
  | Plane { normal; offset } ->
      Some (Plane { normal = c.normal normal; offset = offset *. c.length })
  | Ellipsoid e ->
      Some (Ellipsoid { center = c.point e.center; radii = radii e.radii })
  | Cylinder { from; until; radius } ->
      Some
        (Cylinder
           {
             from = c.point from;
             until = c.point until;
             radius = radius *. c.length;
           })
  | Cone { apex; base; radius } ->
      Some
        (Cone
           {
             apex = c.point apex;
             base = c.point base;
             radius = radius *. c.length;
           })
  | Paraboloid { apex; base; radius } ->
      Some
        (Paraboloid
           {
             apex = c.point apex;
             base = c.point base;
             radius = radius *. c.length;
           })
  | Hyperbolic_paraboloid _ when mirrors_z -> None
  | Hyperbolic_paraboloid e ->
      Some
        (Hyperbolic_paraboloid
           { center = c.point e.center; radii = radii e.radii })
  | Hyperboloid_one_sheet e ->
      Some
        (Hyperboloid_one_sheet
           { center = c.point e.center; radii = radii e.radii })
  | Hyperboloid_two_sheets e ->
      Some
        (Hyperboloid_two_sheets
           { center = c.point e.center; radii = radii e.radii })

let change c = function
  | Sphere s ->
      Some (Sphere (sphere (c.point (Sphere.center s)) (s.radius *. c.length)))
  | Box b ->
      let b = change_box c (b :> Bounds.t) in
      Some (Box (box (Bounds.low b) (Bounds.high b)))
  | Triangle s ->
      let { Triangle.a; b; c = d } = s.corners in
      Some (Triangle (triangle (c.point a) (c.point b) (c.point d)))
  | Quadric q ->
      let clip = Option.map (change_box c) (Quadric.clip q) in
      let caps = Quadric.caps q in
      Option.map
        (fun shape -> Quadric (quadric ?clip ~caps shape))
        (change_shape c (Quadric.shape q))

(** [scaling k] multiplies all lengths by 2^k. *)
let scaling k =
  let by = Float.ldexp 1. k in
  {
    point = (fun q -> p (by *. q.x) (by *. q.y) (by *. q.z));
    normal = Fun.id;
    length = by;
  }

(** [mirror axis] turns the sign of one coordinate. *)
let mirror axis =
  let s i = if i = axis then -1. else 1. in
  {
    point = (fun q -> p (s 0 *. q.x) (s 1 *. q.y) (s 2 *. q.z));
    normal = (fun a -> v (s 0 *. a.x) (s 1 *. a.y) (s 2 *. a.z));
    length = 1.;
  }

(** [change_ray c r] is [r] seen so; its direction keeps its length, so t is
    multiplied by [c.length]. *)
let change_ray c (r : Ray.t) = Ray.v (c.point r.origin) (c.normal r.direction)

(* {1 Drawing} *)

let map_case f { Family.shape; ray } = { Family.shape = f shape; ray }

let of_families make families =
  oneof
    (List.map (fun { Family.cases; _ } -> map (map_case make) cases) families)

(* No extremes: sizes that scaling by 2^±60 leaves in range. *)
let ordinary_spheres =
  Spheres.[ f1; f2; f3; f4; f5; f7; f9; snapped; tangent; central ]

let ordinary_boxes = Boxes.[ aimed; whole; through ]

let ordinary_triangles =
  Triangles.[ ordinary; whole; through; t5; in_plane; on_it; far_away; t7 ]

let ordinary_quadrics =
  Quadrics.
    [
      k1;
      k2;
      k3;
      k4;
      k5;
      k6;
      k7;
      k8;
      whole;
      simply;
      capped;
      clipped;
      whole_clips;
      thin;
    ]

(** Every kind of surface with every kind of ray. *)
let case =
  oneof
    [
      of_families (fun s -> Sphere s) ordinary_spheres;
      of_families (fun b -> Box b) ordinary_boxes;
      of_families (fun s -> Triangle s) ordinary_triangles;
      of_families (fun q -> Quadric q) ordinary_quadrics;
    ]

let show_case = Family.show kind

(* {1 Scenes} *)

type scene = { shapes : t array; ray : Ray.t }

let show_scene { shapes; ray } =
  String.concat "\n" (Array.to_list (Array.map show shapes))
  ^ "\n" ^ show_ray ray

let about (c : Point.t) size =
  let at = map (fun a -> move c a size) (vec (uniform (-1.) 1.)) in
  let thick x = Float.max x (size *. 0.01) in
  let radii = vec (map (fun k -> thick (k *. size)) (uniform 0.1 1.)) in
  oneof
    [
      map (fun r -> Sphere (sphere c (thick (r *. size)))) (uniform 0. 1.);
      map (fun r -> Box (box (Point.add c (Vec.neg r)) (Point.add c r))) radii;
      map (fun s -> Triangle s) (Triangles.triangle_of at);
      map
        (fun radii -> Quadric (quadric (Ellipsoid { center = c; radii })))
        radii;
      (let* axis = unit and* caps = bool and* r = uniform 0.1 1. in
       let until = move c axis size and radius = r *. size in
       let* shape =
         pick
           [
             Quadric_shape.Cylinder { from = c; until; radius };
             Cone { apex = c; base = until; radius };
             Paraboloid { apex = c; base = until; radius };
           ]
       in
       return (Quadric (quadric ~caps shape)));
    ]

let plane =
  let* normal = oneof [ Draw.axial; unit ] and* offset = uniform (-9.) 9. in
  return (Quadric (quadric (Plane { normal; offset })))

let some_of n g = array_size (int_range 1 n) g

(** Arrangements that are hard on a hierarchy. *)
let shapes =
  let place = point (uniform (-9.) 9.) in
  let scattered = place >>= fun c -> wide (-2.) 0.5 >>= about c in
  oneof
    [
      some_of 40 scattered;
      some_of 20 (oneof [ scattered; plane ]);
      (* all centres equal *)
      (let* c = place in
       some_of 20 (map (fun r -> Sphere (sphere c r)) (uniform 0.1 3.)));
      (* all identical *)
      (let* s = scattered in
       some_of 20 (return s));
      (* few kinds, many ties *)
      (let* a = array_size (return 3) scattered in
       some_of 20 (pick (Array.to_list a)));
      (* one huge, many tiny *)
      (let* huge = point (uniform (-1e6) 1e6) >>= fun c -> about c 1e6 in
       let* rest = some_of 30 (place >>= fun c -> about c 1e-3) in
       return (Array.append [| huge |] rest));
      (* flat: triangles of one plane over whole points *)
      some_of 40
        (map
           (fun s -> Triangle s)
           (Triangles.triangle_of
              (map2 (fun x z -> p x 1. z) (small 4) (small 4))));
      (* unit boxes on a grid: shared faces and edges *)
      some_of 40
        (map
           (fun c -> Box (box c (Point.add c (v 1. 1. 1.))))
           (point (small 2)));
    ]

(* A place that the ray can well be aimed at. *)
let target = function
  | Sphere s -> map (fun n -> move (Sphere.center s) n s.radius) unit
  | Box b -> Boxes.point_of b
  | Triangle s -> Triangles.point_of s
  | Quadric q -> Quadrics.landmark (Quadric.shape q)

let scene =
  let* shapes = shapes in
  let* k = int_bound (Array.length shapes - 1) in
  let* ray =
    oneof
      [
        target shapes.(k) >>= ray_at;
        (let* p = target shapes.(k) and* d = oneof [ Draw.axial; unit ] in
         return (Ray.v (move p d (-20.)) d));
        (let* o = point (small 4) and* d = Draw.axial in
         return (Ray.v o d));
      ]
  in
  return { shapes; ray }

let group shapes = Surface.group (Array.mapi surface shapes)
