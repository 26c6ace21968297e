type t = { x : float; y : float; z : float } [@@deriving show, eq, ord]

let[@inline] v x y z = { x; y; z }
let origin = v 0. 0. 0.
let[@inline] add p (a : Vec.t) = v (p.x +. a.x) (p.y +. a.y) (p.z +. a.z)
let[@inline] sub p q = Vec.v (p.x -. q.x) (p.y -. q.y) (p.z -. q.z)

let[@inline] along p (d : Vec.t) t =
  v (Float.fma t d.x p.x) (Float.fma t d.y p.y) (Float.fma t d.z p.z)

let ldexp e p = v (Float.ldexp p.x e) (Float.ldexp p.y e) (Float.ldexp p.z e)

let is_finite p =
  Float.is_finite p.x && Float.is_finite p.y && Float.is_finite p.z

let[@inline] get p i = if i = 0 then p.x else if i = 1 then p.y else p.z
