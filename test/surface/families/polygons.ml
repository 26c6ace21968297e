(** Families for polygons, their corners whole and so exactly in a plane. *)

open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2.Gen
open Draw
open Made

type t = { corners : Point.t list; surface : unit Surface.t }

let make corners =
  let { Polygon.triangles; _ } = get "polygon" (Polygon.make corners) in
  let parts = List.map (fun s -> Surface.triangle s ()) triangles in
  { corners; surface = Surface.group (Array.of_list parts) }

let kind =
  {
    Family.show =
      (fun s -> "polygon " ^ String.concat " " (List.map show_point s.corners));
    answer = (fun s -> answer s.surface);
    truth = (fun s -> Exact_polygon.truth_along s.corners);
  }

let family name cases = { Family.name; cases }
let case shape ray = { Family.shape; ray }

(* {1 Outlines in the plane, counter-clockwise} *)

(* Between two chains from left to right, within -8 < y < 8. *)
let monotone =
  let height = int_range 1 7 in
  let* n = int_range 0 4 and* m = int_range 0 4 in
  let* below = list_size (return n) height
  and* above = list_size (return m) height in
  let width = 1 + Int.max n m in
  let low = List.mapi (fun i y -> (i + 1, -y)) below
  and high = List.rev (List.mapi (fun i y -> (i + 1, y)) above) in
  return (((0, 0) :: low) @ ((width, 0) :: high))

(* As soon as there is anything within. *)
let outline =
  let+ corners = monotone in
  if List.length corners > 2 then corners else [ (0, 0); (3, -1); (1, 4) ]

(* A frame about an outline, joined by a side there and back. *)
let holed =
  let+ inner = outline in
  let start = List.nth inner 0 in
  let frame = [ (9, -9); (9, 9); (-3, 9) ] in
  ((-3, -9) :: frame) @ [ (-3, -9); start ] @ List.rev inner

let twice =
  let+ corners = outline in
  corners @ corners

(* {1 In space} *)

(* The points (x, y, k x + m y), their axes turned, all times a power of 2. *)
let placed outline =
  pool 500
  @@
  let* corners = outline in
  let* k = small 3 and* m = small 3 and* turn = int_bound 2 in
  let* size = either 50 (return 1.) (power (-40) 40) in
  let place (x, y) =
    let x = 4. *. float_of_int x and y = 4. *. float_of_int y in
    let z = (k *. x) +. (m *. y) in
    let x, y, z = (size *. x, size *. y, size *. z) in
    if turn = 0 then p x y z else if turn = 1 then p y z x else p z x y
  in
  return (make (List.map place corners), size)

let middle (a : Point.t) b k = move a (toward a b) k

(* A corner, a point of a side, or one of the plane between three corners. *)
let target corners =
  let n = List.length corners in
  let* i = int_bound (n - 1)
  and* j = int_bound (n - 1)
  and* kind = int_bound 3 in
  let at i = List.nth corners (i mod n) in
  let* u = pick [ 0.25; 0.5; 0.75 ] and* v = pick [ 0.; 0.5; 1. ] in
  return
    (if kind = 0 then at i
     else if kind = 1 then middle (at i) (at (i + 1)) u
     else middle (middle (at i) (at (i + 1)) u) (at j) v)

let exactly name outline =
  family
    (name ^ ", through exact points")
    (let* shape, size = placed outline in
     let* target = target shape.corners in
     let* d = oneof [ vec (small 5); Draw.axial ] in
     let d = if Vec.largest d = 0. then v 0. 1. 0. else d in
     let* k = small 9 in
     return (case shape (Ray.v (move target d (size *. k)) d)))

let nearly name outline =
  family
    (name ^ ", through points up to rounding")
    (let* shape, size = placed outline in
     let* target = target shape.corners and* n = unit and* far = wide 0. 4. in
     let* k = uniform 0.5 2. in
     let o = move target n (size *. far) in
     return (case shape (Ray.v o (Vec.scale k (toward o target)))))

let along_sides =
  family "along sides, in the plane and almost"
    (let* shape, size = placed (oneof [ outline; holed ]) in
     let n = List.length shape.corners in
     let* i = int_bound (n - 1)
     and* u = pick [ -0.5; 0.; 0.25; 0.5; 1.; 1.5 ] in
     let at i = List.nth shape.corners (i mod n) in
     let side = toward (at i) (at (i + 1)) in
     let side = if Vec.largest side = 0. then v size 0. 0. else side in
     let* e = oneof [ return 0.; wide (-17.) (-1.) ] and* off = unit in
     let d = Vec.add side (Vec.scale (e *. size) off) in
     let* k = oneof [ small 3; uniform (-3.) 0. ] in
     return (case shape (Ray.v (move (middle (at i) (at (i + 1)) u) d k) d)))

let all =
  [
    exactly "concave outlines" outline;
    nearly "concave outlines" outline;
    exactly "holes" holed;
    nearly "holes" holed;
    exactly "outlines run twice" twice;
    along_sides;
  ]
