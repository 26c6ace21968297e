open Candor_number
open Candor_space

type corners = { a : Point.t; b : Point.t; c : Point.t }
[@@deriving show, eq, ord]

type uv = {
  ua : float;
  va : float;
  ub : float;
  vb : float;
  uc : float;
  vc : float;
}
[@@deriving show, eq, ord]

type t = {
  corners : corners;
  normals : (Vec.t * Vec.t * Vec.t) option;
  uv : uv option;
}
[@@deriving show, eq, ord]

let size (p : Point.t) = Vec.largest (Point.sub p Point.origin)
let size_of { a; b; c } = Float.max (size a) (Float.max (size b) (size c))

let shift e (p : Point.t) =
  Point.v (Float.ldexp p.x e) (Float.ldexp p.y e) (Float.ldexp p.z e)

let rescaled e { a; b; c } = { a = shift e a; b = shift e b; c = shift e c }

(* The power of two that brings numbers up to [m] near 2^300: exact, and the
   products of three of them are then as far from overflow as can be, which
   keeps their smallest bits from underflow. *)
let raise_to_300 m = 300 - snd (Float.frexp m)

let has_area corners =
  let { a; b; c } = rescaled (raise_to_300 (size_of corners)) corners in
  let n = Expansion.cross (Unrounded.diff b a) (Unrounded.diff c a) in
  Expansion.(sign n.x <> 0 || sign n.y <> 0 || sign n.z <> 0)

let directions (a, b, c) =
  match (Dir.of_vec a, Dir.of_vec b, Dir.of_vec c) with
  | Some a, Some b, Some c -> Some (a, b, c)
  | None, _, _ | _, None, _ | _, _, None -> None

let make ?normals ?uv corners =
  let { a; b; c } = corners in
  if not (Reach.point a && Reach.point b && Reach.point c) then
    Error Reach.message
  else if not (has_area corners) then
    Error "the triangle has no area: its corners lie on one line"
  else if
    Option.is_some normals && Option.is_none (Option.bind normals directions)
  then Error "a normal must be finite and not zero"
  else Ok { corners; normals; uv }

let bounds { corners = { a; b; c }; _ } = Bounds.of_points [ a; b; c ]

(* {1 Meeting} *)

let[@inline] largest x y z =
  let x = Float.abs x and y = Float.abs y and z = Float.abs z in
  let m = if y > x then y else x in
  if z > m then z else m

let[@inline] largest3 (v : Vec.t) m =
  let l = largest v.x v.y v.z in
  if l > m then l else m

(* The corners as seen from the origin, and the direction, all exact: lengths
   times 2^length, the direction times 2^time. *)
type view = {
  to_a : Expansion.vec;
  to_b : Expansion.vec;
  to_c : Expansion.vec;
  toward : Expansion.vec;
  length : int;
  time : int;
}

let view corners o (d : Vec.t) =
  let length = raise_to_300 (Float.max (size_of corners) (size o)) in
  let time = raise_to_300 (Vec.largest d) in
  let o = shift length o and { a; b; c } = rescaled length corners in
  let part x = Expansion.of_float (Float.ldexp x time) in
  {
    to_a = Unrounded.diff a o;
    to_b = Unrounded.diff b o;
    to_c = Unrounded.diff c o;
    toward = { x = part d.x; y = part d.y; z = part d.z };
    length;
    time;
  }

(* The sign of d.((p - o) x (r - o)) with the tie broken. *)
let exact_edge d p r =
  let m = Expansion.cross p r in
  let rec first = function
    | [] -> 0
    | x :: rest -> ( match Expansion.sign x with 0 -> first rest | s -> s)
  in
  match Expansion.sign (Expansion.dot d m) with
  | 0 -> first [ m.x; m.y; m.z ]
  | s -> s

let exact_edges corners o d =
  let { to_a = a; to_b = b; to_c = c; toward = d; _ } = view corners o d in
  let ea = exact_edge d b c and eb = exact_edge d c a in
  if ea = eb && eb = exact_edge d a b then ea else 0

(* -1, 0 or 1: on which side of all three edges the ray passes, 0 if it passes
   outside of the triangle. *)
let crossing corners (o : Point.t) (d : Vec.t) =
  let a = Point.sub corners.a o
  and b = Point.sub corners.b o
  and c = Point.sub corners.c o in
  let ea = Vec.dot d (Vec.cross b c)
  and eb = Vec.dot d (Vec.cross c a)
  and ec = Vec.dot d (Vec.cross a b) in
  let m = largest3 a (largest3 b (largest3 c 0.)) in
  (* Shewchuk's bound for a 3x3 determinant is (7 + 56u)u times its permanent,
     which is at most 6 times the product of its rows' largest entries. *)
  let doubt = 0x1.6p-48 *. m *. m *. largest3 d 0. in
  if not (doubt > 0x1p-900 && doubt < 0x1p900) then exact_edges corners o d
  else if ea > doubt && eb > doubt && ec > doubt then 1
  else if ea < -.doubt && eb < -.doubt && ec < -.doubt then -1
  else if
    (ea > doubt || eb > doubt || ec > doubt)
    && (ea < -.doubt || eb < -.doubt || ec < -.doubt)
  then 0
  else exact_edges corners o d

let exact_distance corners o d =
  let view = view corners o d in
  let minus (p : Expansion.vec) (q : Expansion.vec) =
    let open Expansion in
    { x = sub p.x q.x; y = sub p.y q.y; z = sub p.z q.z }
  in
  let { to_a; to_b; to_c; toward; length; time } = view in
  let n = Expansion.cross (minus to_b to_a) (minus to_c to_a) in
  let t = Expansion.(ratio (dot to_a n) (dot toward n)) in
  Float.ldexp t (time - length)

(* Where the ray crosses the plane: ((a - o).n) / (d.n) with n = (b-a) x (c-a).
   Near the plane or along it both products cancel, so every number is carried as
   a sum of two doubles; written out, since nothing here may allocate. *)
let plane_distance ({ a; b; c } as corners) (o : Point.t) (d : Vec.t) =
  let open Error_free in
  let px = b.x -. a.x and py = b.y -. a.y and pz = b.z -. a.z in
  let qx = c.x -. a.x and qy = c.y -. a.y and qz = c.z -. a.z in
  let rx = a.x -. o.x and ry = a.y -. o.y and rz = a.z -. o.z in
  (* What the differences lost. *)
  let px' = sum_error b.x (-.a.x) px
  and py' = sum_error b.y (-.a.y) py
  and pz' = sum_error b.z (-.a.z) pz in
  let qx' = sum_error c.x (-.a.x) qx
  and qy' = sum_error c.y (-.a.y) qy
  and qz' = sum_error c.z (-.a.z) qz in
  let rx' = sum_error a.x (-.o.x) rx
  and ry' = sum_error a.y (-.o.y) ry
  and rz' = sum_error a.z (-.o.z) rz in
  (* n and its error *)
  let yz = py *. qz and zy = pz *. qy in
  let zx = pz *. qx and xz = px *. qz in
  let xy = px *. qy and yx = py *. qx in
  let nx = yz -. zy and ny = zx -. xz and nz = xy -. yx in
  let nx' =
    sum_error yz (-.zy) nx +. product_error py qz yz -. product_error pz qy zy
    +. ((py' *. qz) +. (py *. qz') -. (pz' *. qy) -. (pz *. qy'))
  and ny' =
    sum_error zx (-.xz) ny +. product_error pz qx zx -. product_error px qz xz
    +. ((pz' *. qx) +. (pz *. qx') -. (px' *. qz) -. (px *. qz'))
  and nz' =
    sum_error xy (-.yx) nz +. product_error px qy xy -. product_error py qx yx
    +. ((px' *. qy) +. (px *. qy') -. (py' *. qx) -. (py *. qx'))
  in
  (* d.n *)
  let x = d.x *. nx and y = d.y *. ny and z = d.z *. nz in
  let xy = x +. y in
  let sum = xy +. z in
  let across =
    sum
    +. (sum_error x y xy +. sum_error xy z sum +. product_error d.x nx x
      +. product_error d.y ny y +. product_error d.z nz z
       +. ((d.x *. nx') +. (d.y *. ny') +. (d.z *. nz')))
  in
  (* (a - o).n *)
  let x = rx *. nx and y = ry *. ny and z = rz *. nz in
  let xy = x +. y in
  let sum = xy +. z in
  let away =
    sum
    +. (sum_error x y xy +. sum_error xy z sum +. product_error rx nx x
      +. product_error ry ny y +. product_error rz nz z
       +. ((rx *. nx') +. (ry *. ny') +. (rz *. nz'))
       +. ((rx' *. nx) +. (ry' *. ny) +. (rz' *. nz)))
  in
  (* Both are off by less than 2^-99 of the product of their largest factors;
     where that could matter, or the range is left, they are taken exactly. *)
  let n = largest px py pz *. largest qx qy qz in
  let least_across = 0x1p-45 *. n *. largest d.x d.y d.z
  and least_away = 0x1p-45 *. n *. largest rx ry rz in
  if
    Float.abs across > least_across
    && Float.abs away > least_away
    && least_across > 0x1p-900 && least_away > 0x1p-900
    && Float.abs across < infinity
    && Float.abs away < infinity
  then away /. across
  else exact_distance corners o d

let meet s o d left cursor =
  if not (Contact.is_none left) then Contact.none
  else
    match crossing s.corners o d with
    | 0 -> Contact.none
    | sign ->
        let side : Side.t = if sign < 0 then Outside else Inside in
        let t = plane_distance s.corners o d in
        Cursor.take cursor t (Contact.v ~part:0 side)

(* {1 Locating} *)

(* A product of vectors is far below that of their sizes where it cancels: in
   needles, and seen from along the plane. Then it is taken exactly. *)
let[@inline] cancels x size = not (Float.abs x > 0x1p-16 *. size)

let exact_normal corners =
  let { a; b; c } = rescaled (raise_to_300 (size_of corners)) corners in
  let n = Expansion.cross (Unrounded.diff b a) (Unrounded.diff c a) in
  Vec.v (Expansion.to_float n.x) (Expansion.to_float n.y)
    (Expansion.to_float n.z)

let normal corners =
  let p = Point.sub corners.b corners.a and q = Point.sub corners.c corners.a in
  let n = Vec.cross p q and size = Vec.largest p *. Vec.largest q in
  let plain = size > 0x1p-900 && not (cancels (Vec.largest n) size) in
  Dir.of_vec_or Dir.z (if plain then n else exact_normal corners)

let exact_weights corners o d =
  let { to_a; to_b; to_c; toward; _ } = view corners o d in
  let volume p q = Expansion.(dot toward (cross p q)) in
  let eb = volume to_c to_a and ec = volume to_a to_b in
  let sum = Expansion.(add (volume to_b to_c) (add eb ec)) in
  (Expansion.ratio eb sum, Expansion.ratio ec sum)

(* The weights of b and c where the line crosses the plane. *)
let weights corners o d =
  let p = Point.sub corners.b corners.a
  and q = Point.sub corners.c corners.a
  and r = Point.sub corners.a o in
  let across = Vec.dot d (Vec.cross p q) in
  let size = Vec.largest p *. Vec.largest q *. Vec.largest d in
  let far = size *. Vec.largest r in
  if cancels across size || not (far > 0x1p-900 && far < 0x1p900) then
    exact_weights corners o d
  else (Vec.dot d (Vec.cross q r) /. across, Vec.dot d (Vec.cross r p) /. across)

let clamp w ~most = if w > 0. then if w < most then w else most else 0.

let locate { corners; normals; uv } o d =
  let wb, wc = weights corners o d in
  (* Together they stay 1, or the point would leave the plane. *)
  let wb = clamp wb ~most:1. in
  let wc = clamp wc ~most:(1. -. wb) in
  let wa = 1. -. wb -. wc in
  let mix x y z = (wa *. x) +. (wb *. y) +. (wc *. z) in
  let { a; b; c } = corners in
  let spread x y z =
    let size = mix (Float.abs x) (Float.abs y) (Float.abs z) in
    7. *. 0x1p-53 *. size
  in
  let smooth ((na : Dir.t), (nb : Dir.t), (nc : Dir.t)) =
    let na = (na :> Vec.t) and nb = (nb :> Vec.t) and nc = (nc :> Vec.t) in
    Dir.of_vec
      (Vec.v (mix na.x nb.x nc.x) (mix na.y nb.y nc.y) (mix na.z nb.z nc.z))
  in
  {
    Local.point = Point.v (mix a.x b.x c.x) (mix a.y b.y c.y) (mix a.z b.z c.z);
    normal = normal corners;
    error = Vec.v (spread a.x b.x c.x) (spread a.y b.y c.y) (spread a.z b.z c.z);
    flat = true;
    uv =
      lazy
        (match uv with
        | Some t -> Some (mix t.ua t.ub t.uc, mix t.va t.vb t.vc)
        | None -> Some (wb, wc));
    shading_normal = Option.bind (Option.bind normals directions) smooth;
  }
