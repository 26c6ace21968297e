(** Families for quadrics that are cut close to where they are met. *)

open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2.Gen
open Draw
open Made

let kind = Quadrics.kind
let family name cases = { Family.name; cases }
let case shape ray = { Family.shape; ray }

(* Up to two ulps either way. Near 0 an ulp is taken to be 2^-200: the square of
   a smaller number is none. *)
let within_ulps x =
  let+ k = int_range (-2) 2 in
  let rec step k x =
    if k = 0 then x
    else if k < 0 then step (k + 1) (Float.pred x)
    else step (k - 1) (Float.succ x)
  in
  if x = 0. then float_of_int k *. 0x1p-200 else step k x

let whole_axis = (-0x1p60, 0x1p60)

(* The clip box with these ends on one axis. *)
let slab axis (lo, hi) =
  let on i = if i = axis then (lo, hi) else whole_axis in
  let (x0, x1), (y0, y1), (z0, z1) = (on 0, on 1, on 2) in
  Bounds.v (p x0 y0 z0) (p x1 y1 z1)

(* A slab that ends at [x], with the rest of space on either side. *)
let half axis x =
  let+ keeps_low = bool in
  slab axis (if keeps_low then (fst whole_axis, x) else (x, snd whole_axis))

let ellipsoid =
  let* center = Quadrics.place and* radii = Quadrics.radii in
  return (center, radii)

(* A point of an ellipsoid with a direction along the surface there. *)
let tangent ((center : Point.t), (radii : Vec.t)) =
  let* n = oneof [ Draw.axial; unit ] in
  let at =
    Point.add center (v (n.x *. radii.x) (n.y *. radii.y) (n.z *. radii.z))
  in
  let slope = v (n.x /. radii.x) (n.y /. radii.y) (n.z /. radii.z) in
  let+ d = across slope in
  (at, normalised slope, d)

let silhouette =
  family "Q12 a clip face through the silhouette"
    (let* ((center, radii) as e) = ellipsoid in
     let* at, out, d = tangent e and* axis = int_bound 2 in
     let* x = within_ulps (Point.get at axis) in
     let* clip = half axis x in
     let* sink = oneof [ return 0.; signed (wide (-16.) (-2.)) ] in
     let* far = wide (-1.) 3. in
     let o = move (move at out sink) d (-.far) in
     return (case (quadric ~clip (Ellipsoid { center; radii })) (Ray.v o d)))

(* A named shape and a ray that meets it, with the first t. *)
let met =
  let* shape = Quadrics.named in
  let* target = Quadrics.landmark shape in
  let+ ray = ray_at target in
  let first = Surface.nearest (Surface.quadric (quadric shape) ()) ray in
  (shape, ray, Option.fold ~none:1. ~some:(fun (h : _ Hit.t) -> h.t) first)

let clipped shape clip ray =
  match Quadric.make ~clip shape with
  | Ok q -> case q ray
  | Error _ -> case (quadric shape) ray

let on_face =
  family "Q12 hits on a clip face, within two ulps"
    (let* shape, ray, t = met and* axis = int_bound 2 in
     let* x = within_ulps (Point.get (Ray.at ray t) axis) in
     let* clip = half axis x in
     return (clipped shape clip ray))

let either_root =
  family "Q13 the first root clipped, the second, both or neither"
    (let* shape, ray, t = met and* axis = int_bound 2 in
     let place k = Point.get (Ray.at ray (t *. k)) axis in
     let* a = oneof [ uniform 0.5 1.; map (fun e -> 1. -. e) (wide (-16.) 0.) ]
     and* b =
       oneof [ uniform 1. 3.; map (fun e -> 1. +. e) (wide (-16.) 0.) ]
     in
     let* c = oneof [ uniform 1. 9.; return a; return b ] in
     let a, b = (place a, place (Float.max b c)) in
     return (clipped shape (slab axis (Float.min a b, Float.max a b)) ray))

let all = [ silhouette; on_face; either_root ]
