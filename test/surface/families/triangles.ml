(** Families for triangles. *)

open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2.Gen
open Draw
open Made

let show (s : Triangle.t) =
  let { Triangle.a; b; c } = s.corners in
  Printf.sprintf "triangle %s %s %s" (show_point a) (show_point b)
    (show_point c)

let kind =
  {
    Family.show;
    answer = (fun s -> answer (Surface.triangle s ()));
    truth = Exact_triangle.truth_along;
  }

let family name cases = { Family.name; cases }
let case shape ray = { Family.shape; ray }

(* Where there is no area, a fixed triangle. *)
let between a b c =
  match Triangle.make { a; b; c } with
  | Ok s -> s
  | Error _ -> triangle (p 0. 0. 0.) (p 1. 0. 0.) (p 0. 1. 0.)

let triangle_of corner =
  let* a = corner and* b = corner and* c = corner in
  return (between a b c)

let corners (s : Triangle.t) = s.corners
let middle (a : Point.t) (b : Point.t) k = move a (toward a b) k

(* A corner, a point of an edge, or one within; up to rounding. *)
let point_of s =
  let { Triangle.a; b; c } = corners s in
  let inside = uniform 0. 1. in
  oneof
    [
      pick [ a; b; c ];
      map (middle a b) (oneof [ return 0.5; inside ]);
      map (middle b c) (oneof [ return 0.5; inside ]);
      map (middle c a) (oneof [ return 0.5; inside ]);
      map2 (fun u v -> middle (middle a b u) c (v *. v)) inside inside;
    ]

let random = triangle_of (point (uniform (-3.) 3.))

let plain =
  family "ordinary triangles, met anywhere and missed"
    (let* s = random and* target = point (uniform (-2.) 2.) in
     let* o = point (uniform (-9.) 9.) in
     let { Triangle.a; b; c } = corners s in
     let* u = uniform 0. 1. and* v = uniform 0. 1. and* inside = bool in
     let within = middle (middle a b u) c v in
     let target = if inside then within else target in
     return (case s (Ray.v o (toward o target))))

let ordinary =
  family "triangles aimed at corners, edges and faces"
    (let* s = random in
     let* target = point_of s and* o = point (uniform (-9.) 9.) in
     return (case s (Ray.v o (toward o target))))

let whole =
  family "whole numbers: exact ties at corners and edges"
    (let* s = triangle_of (point (small 4)) in
     let* o = point (small 6) and* d = vec (small 4) in
     let d = if Vec.largest d = 0. then Vec.v 0. 0. (-1.) else d in
     return (case s (Ray.v o d)))

let through =
  family "through exact points of corners, edges and faces"
    (let* s = triangle_of (point (map (fun x -> 4. *. x) (small 9))) in
     let { Triangle.a; b; c } = corners s in
     let* u = map (fun k -> k /. 4.) (map Float.abs (small 4)) in
     let* v = pick [ 0.; 0.; 0.5; 1. ] in
     let target = middle (middle a b u) c v in
     let* d = oneof [ vec (small 9); axial ] in
     let d = if Vec.largest d = 0. then Vec.v 0. 1. 0. else d in
     let* k = small 9 and* z = power (-40) 40 in
     let scale (q : Point.t) = p (z *. q.x) (z *. q.y) (z *. q.z) in
     let s = triangle (scale a) (scale b) (scale c) in
     return (case s (Ray.v (scale (move target d k)) d)))

(* Nearly in the plane of the triangle. *)
let skimming lo hi =
  let* n = unit in
  let* t1 = across n in
  let t2 = Vec.cross n t1 in
  let at u v = Vec.add (Vec.scale u t1) (Vec.scale v t2) in
  let from a = Point.add Point.origin a in
  let* a = uniform 1. 3. and* b = uniform 1. 3. and* c = uniform 1. 3. in
  let* b' = uniform 0.5 2. and* c' = uniform 0.5 2. in
  let s =
    between (from (at a 0.)) (from (at (-.b) b')) (from (at (-.c) (-.c')))
  in
  let* u = uniform (-1.) 1. and* v = uniform (-1.) 1. and* tilt = wide lo hi in
  let dir = normalised (Vec.add (at u v) (Vec.scale tilt n)) in
  let* u = uniform (-0.1) 0.1
  and* v = uniform (-0.1) 0.1
  and* far = wide 0. 2. in
  return (case s (Ray.v (move (from (at u v)) dir (-.far)) dir))

let t5 = family "T5 within 1e-1..1e-12 of the plane" (skimming (-12.) (-1.))
let flat = family "within 1e-12..1e-17 of the plane" (skimming (-17.) (-12.))

let in_plane =
  family "in the plane, exactly or up to rounding"
    (let* s = oneof [ triangle_of (point (small 6)); random ] in
     let { Triangle.a; b; c } = corners s in
     let ab = toward a b and ac = toward a c in
     let* u = small 4 and* v = small 4 in
     let d = Vec.add (Vec.scale u ab) (Vec.scale v ac) in
     let d = if Vec.largest d = 0. then ab else d in
     let* target = point_of s
     and* k = oneof [ small 5; uniform (-4.) 4.; return 0. ] in
     return (case s (Ray.v (move target d k) d)))

(* The whole plane is z = x, say: exact points of it at any number. *)
let on_it =
  family "from an exact point of its plane"
    (let number = oneof [ small 4; uniform (-4.) 4. ] in
     let* k = pick [ 0.; 1.; -1.; 2. ] in
     let corner =
       let* x = number and* y = number in
       return (p x y (k *. x))
     in
     let* s = triangle_of corner in
     let* o =
       oneof
         [
           corner;
           map
             (fun { Triangle.a; b; c } -> List.nth [ a; b; c ] 0)
             (return (corners s));
         ]
     in
     let* d =
       oneof
         [
           unit;
           vec (small 4);
           (let* q = corner in
            return (toward o q));
         ]
     in
     let d = if Vec.largest d = 0. then Vec.v 0. 0. 1. else d in
     return (case s (Ray.v o d)))

let needles =
  family "needles and slivers"
    (let* a = point coordinate and* along = unit and* long = wide (-3.) 9. in
     let* thin = wide (-14.) 0. and* w = unit and* k = uniform 0. 1. in
     let b = move a along long in
     let c = move (middle a b k) w (thin *. long) in
     let s = between a b c in
     let* target = point_of s in
     let* ray = ray_at target in
     return (case s ray))

let far_away =
  family "small and far from the origin"
    (let* at = point (signed (wide 3. 9.)) and* size = wide (-5.) 2. in
     let corner = map (fun a -> move at a size) (vec (uniform (-1.) 1.)) in
     let* s = triangle_of corner in
     let* target = point_of s and* d = unit and* k = wide (-2.) 3. in
     let o = move target d (-.(k *. size)) in
     return (case s (Ray.v o (toward o target))))

let t7 =
  family "close to one line, as pbrt's bad cases"
    (let x = -1113.45459 and y = -79.049614 and z = -56.2431908 in
     let corner = map (fun k -> p (x +. k) y z) (uniform (-0.01) 0.01) in
     let* a = corner and* b = corner and* c = corner in
     let* e = signed (wide (-14.) (-10.)) in
     let s = between a b { c with y = c.y +. e } in
     let* target = point_of s in
     let o = p (-1081.47925) 99.9999542 87.7701111 in
     return (case s (Ray.v o (toward o target))))

let micro =
  family "scales from 1e-30 to 1e30, directions too"
    (let* k = wide (-30.) 30. and* k' = wide (-100.) 100. in
     let at = map (fun x -> k *. x) (uniform (-3.) 3.) in
     let* s = triangle_of (point at) in
     let* target = point_of s and* o = point at in
     let d = toward o target in
     return (case s (Ray.v o (Vec.scale k' (normalised d)))))

let anything =
  family "anything at all"
    (let* s = triangle_of (point coordinate) in
     let* target = point_of s in
     let* ray = ray_at target in
     return (case s ray))

let all =
  [
    plain;
    ordinary;
    whole;
    through;
    t5;
    flat;
    in_plane;
    on_it;
    needles;
    far_away;
    t7;
    micro;
    anything;
  ]
