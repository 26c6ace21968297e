open Candor_space

type t = { velocity : Vec.t; shutter : float * float }

let v ~velocity ~shutter = { velocity; shutter }
let displacement m time = Vec.scale time m.velocity

(* Rounding keeps order: at all times between, the displacement is between those
   at both ends. *)
let sweep m (b : Bounds.t) =
  let d = displacement m (fst m.shutter)
  and e = displacement m (snd m.shutter) in
  let down x d = if d = 0. then x else Float.pred (x +. d)
  and up x d = if d = 0. then x else Float.succ (x +. d) in
  let low x d e = Float.min (down x d) (down x e)
  and high x d e = Float.max (up x d) (up x e) in
  Bounds.v
    (Point.v (low b.x0 d.x e.x) (low b.y0 d.y e.y) (low b.z0 d.z e.z))
    (Point.v (high b.x1 d.x e.x) (high b.y1 d.y e.y) (high b.z1 d.z e.z))

let map (d : Vec.t) =
  Wide_affine.of_affine { Affine.identity with xt = d.x; yt = d.y; zt = d.z }

let follow d ray = Object_ray.through (map (Vec.neg d)) ray
